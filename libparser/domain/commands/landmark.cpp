#include "libparser/domain/commands/landmark.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "libltl/diagnostic.hpp"
#include "libparser/domain/commands/file_text.hpp"

namespace waymark::parser {
namespace {

Landmark landmark_of(std::string proposition, const nlohmann::json& entry) {
  Landmark l{std::move(proposition), entry.value("name", ""), {}, {}};
  if (entry.contains("other_names")) l.other_names = entry.at("other_names").get<std::vector<std::string>>();
  if (entry.contains("tags"))
    for (const auto& [key, value] : entry.at("tags").items())
      if (value.is_string()) l.tags[key] = value.get<std::string>();
  return l;
}

}  // namespace

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  std::vector<Landmark> all;
  try {
    const nlohmann::json json = nlohmann::json::parse(text_of(file));
    for (const auto& entry : json.at("landmarks"))
      all.push_back(landmark_of(entry.at("prop").get<std::string>(), entry));
  } catch (const nlohmann::json::exception& e) {
    throw ltl::FormatError(file.string(), 0, 0, std::string("no map of landmarks: ") + e.what());
  }
  return all;
}

std::vector<Landmark> read_propositions(const std::filesystem::path& file) {
  std::vector<Landmark> all;
  try {
    const nlohmann::json json = nlohmann::json::parse(text_of(file));
    for (const auto& [proposition, said] : json.at("propositions").items()) {
      const bool is_description = said.is_string();
      Landmark l = is_description ? Landmark{proposition, "", {}, {}} : landmark_of(proposition, said);
      if (l.name.empty()) {
        l.name = proposition;
        std::replace(l.name.begin(), l.name.end(), '_', ' ');
      }
      const std::string description = is_description ? said.get<std::string>() : said.value("description", "");
      if (!description.empty()) l.tags[description_tag] = description;
      all.push_back(std::move(l));
    }
  } catch (const nlohmann::json::exception& e) {
    throw ltl::FormatError(file.string(), 0, 0, std::string("no named propositions: ") + e.what());
  }
  return all;
}

}  // namespace waymark::parser
