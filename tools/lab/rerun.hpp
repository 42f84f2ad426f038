// An experiment made again: data/experiments/NAME.transcript has its commands and what they printed.
#pragma once
#include <string>

#include "tools/shell/command.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct RerunOptions {
  std::string name;    // of the experiment
  bool check = false;  // say what differs from the transcript, not what the commands print
  bool fast = false;   // stop at the line "# slow"
  std::string data;    // as --data
};

void add_rerun_options(Command command, RerunOptions& options);

// In a temporary directory that is removed. Done when all lines agree, No when one differs. Throws ltl::FormatError
// for a transcript that is not there or cannot be read, Interrupted.
ExitCode rerun(const RerunOptions& options, const Session& session);

}  // namespace waymark::tools
