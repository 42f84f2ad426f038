#include "tools/shell/command_training.hpp"

#include <filesystem>
#include <sstream>

#include "tools/shell/data_directory.hpp"
#include "tools/shell/input.hpp"

namespace waymark::tools {

void add_command_training_options(Command command, CommandTrainingOptions& options) {
  const std::string group = "Commands";
  command
      .add_option("--commands", options.files,
                  "English commands with formulas to learn from, JSON Lines; 'own': our own language alone")
      .type_name("FILE")
      .group(group);
  command.add_option("--domains", options.domains, "what commands speak of (else domains.json beside the first file)")
      .type_name("FILE")
      .group(group);
  command.add_option("--maps", options.maps, "maps of landmarks (else maps beside the first file)")
      .type_name("DIR")
      .group(group);
  command.add_option("--networks", options.how.networks, "networks that vote on a command")
      .type_name("N")
      .between(1, 16)
      .show_default()
      .group(group);
  command.add_option("--own-commands", options.how.own.texts, "commands of our own language")
      .type_name("N")
      .show_default()
      .group(group);
  command.add_option("--own-weight", options.how.own.weight, "of one of them, compared with one of people's")
      .type_name("X")
      .show_default()
      .group(group);
  command
      .add_option("--matcher-draws", options.how.matcher.draws,
                  "commands that the matcher is learned from, with repetitions")
      .type_name("N")
      .show_default()
      .group(group);
  command.add_option("--command-epochs", options.how.network.epochs, "passes over all commands")
      .type_name("N")
      .between(1, 1000)
      .show_default()
      .group(group);
}

parser::CommandDomains domains_of(const CommandTrainingOptions& options, const std::string& file) {
  const std::filesystem::path beside = std::filesystem::path(file).parent_path();
  if (options.domains.empty() && options.maps.empty() && !std::filesystem::exists(beside / "domains.json")) return {};
  return {options.domains.empty() ? beside / "domains.json" : std::filesystem::path(options.domains),
          options.maps.empty() ? beside / "maps" : std::filesystem::path(options.maps)};
}

std::vector<parser::Command> commands_of(const std::vector<std::string>& files, bool clean) {
  std::vector<parser::Command> all;
  for (const std::string& file : files) {
    if (file == "own") continue;
    for (parser::Command& command : parser::read_commands(file))
      if (!clean || !command.suspect) all.push_back(std::move(command));
  }
  return all;
}

std::shared_ptr<const parser::WordVectors> read_vectors(const std::string& data) {
  return parser::LiftedReader::load_vectors(data_directory(data) / "words" / "words.waymark");
}
std::vector<std::string> read_synonyms(const std::string& data) {
  std::istringstream lines(read_file((data_directory(data) / "words" / "synonyms.txt").string()));
  std::vector<std::string> groups;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) groups.push_back(line);
  return groups;
}
parser::SynchronousGrammar read_grammar(const std::string& data) {
  return parser::SynchronousGrammar(data_directory(data) / "language" / "commands.grammar");
}

}  // namespace waymark::tools
