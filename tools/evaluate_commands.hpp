// waymark evaluate --commands: how many commands are read as they are labelled.
#pragma once
#include <string>
#include <vector>

#include "tools/shell/command_training.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct CommandsRequest {
  CommandTrainingOptions training;
  std::vector<std::string> folds, tests;  // ids that are tested, one table each; files that are tested
  std::string predictions, model_file, data;
  std::uint64_t seed = 1;
  bool clean = false, json = false, marks = false;
  double least = 0;  // answers that are less likely are refused
};
void add_commands_request(Command command, CommandsRequest& request);
ExitCode evaluate_commands(const CommandsRequest& request, const Session& session);

}  // namespace waymark::tools
