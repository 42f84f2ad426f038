#include "libparser/domain/commands/landmark.hpp"

#include <nlohmann/json.hpp>

#include "libltl/diagnostic.hpp"
#include "libparser/domain/commands/file_text.hpp"

namespace waymark::parser {

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  std::vector<Landmark> all;
  try {
    const nlohmann::json json = nlohmann::json::parse(text_of(file));
    for (const auto& entry : json.at("landmarks")) {
      Landmark l{entry.at("prop").get<std::string>(), entry.value("name", ""), {}, {}};
      if (entry.contains("other_names")) l.other_names = entry.at("other_names").get<std::vector<std::string>>();
      if (entry.contains("tags"))
        for (const auto& [key, value] : entry.at("tags").items())
          if (value.is_string()) l.tags[key] = value.get<std::string>();
      all.push_back(std::move(l));
    }
  } catch (const nlohmann::json::exception& e) {
    throw ltl::FormatError(file.string(), 0, 0, std::string("no map of landmarks: ") + e.what());
  }
  return all;
}

}  // namespace waymark::parser
