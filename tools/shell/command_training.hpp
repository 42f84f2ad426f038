// --commands and what belongs to it: where commands and their domains are, and how a reader of them is learned.
#pragma once
#include <string>
#include <vector>

#include "libparser/domain/commands/evaluate_commands.hpp"
#include "tools/shell/command.hpp"

namespace waymark::tools {

struct CommandTrainingOptions {
  std::vector<std::string> files;  // of commands, or "own"
  std::string domains, maps;       // empty: domains.json and maps beside the first file
  parser::CommandsExperiment how;
};
void add_command_training_options(Command command, CommandTrainingOptions& options);

// `file`: one of commands, beside which domains are looked for when none are named.
parser::CommandDomains domains_of(const CommandTrainingOptions& options, const std::string& file);
// Of all files but "own". Throws ltl::FormatError naming the line.
std::vector<parser::Command> commands_of(const std::vector<std::string>& files, bool clean);

// Word vectors, synonyms and grammar of the data directory.
std::shared_ptr<const parser::WordVectors> read_vectors(const std::string& data);
std::vector<std::string> read_synonyms(const std::string& data);  // groups
parser::SynchronousGrammar read_grammar(const std::string& data);

}  // namespace waymark::tools
