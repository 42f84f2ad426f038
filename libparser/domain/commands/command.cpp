#include "libparser/domain/commands/command.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"

namespace waymark::parser {
namespace {

std::istringstream open(const std::filesystem::path& file) { return std::istringstream(ltl::read_text(file)); }

Command command_of(const nlohmann::json& json) {
  Command c;
  c.id = json.at("id").get<std::string>();
  c.domain = json.at("domain").get<std::string>();
  c.from = json.value("from", "");
  c.source = json.value("source", "");
  c.type = json.value("type", "free");
  c.n = json.value("n", std::size_t{0});
  c.lifted = json.value("lifted", false);
  c.text = json.at("text").get<std::string>();
  c.formula = json.value("formula", "");
  c.count = json.value("count", std::size_t{1});
  c.suspect = json.contains("suspect");
  if (json.contains("propositions")) c.propositions = json.at("propositions").get<std::vector<std::string>>();
  if (json.contains("landmarks"))
    for (const auto& [proposition, words] : json.at("landmarks").items())
      c.landmarks[proposition] = words.is_null() ? std::nullopt : std::optional(words.get<std::string>());
  return c;
}

}  // namespace

std::vector<Command> read_commands(const std::filesystem::path& file) {
  std::istringstream in = open(file);
  std::vector<Command> all;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty()) continue;
    try {
      all.push_back(command_of(nlohmann::json::parse(line)));
    } catch (const nlohmann::json::exception& e) {
      throw ltl::FormatError(file.string(), number, 0, std::string("no command: ") + e.what());
    }
  }
  return all;
}

std::vector<std::string> read_fold(const std::filesystem::path& file) {
  std::istringstream in = open(file);
  std::vector<std::string> ids;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line))
    if (!line.empty()) ids.push_back(line.substr(0, line.find('\t')));
  return ids;
}

}  // namespace waymark::parser
