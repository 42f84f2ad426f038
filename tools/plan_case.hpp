// waymark plan --case: every task of a planning case → its value between proved bounds.
#pragma once
#include <string>

#include "tools/shell/exit_code.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {

struct CaseChoice {
  std::string file, task, method = "best";
  double tolerance = 1e-6;
  double limit_seconds = 0;  // of each task; 0: none
  bool json = false;
};
void add_case_options(CLI::App& command, CaseChoice& choice);
ExitCode plan_case(const CaseChoice& choice, const Session& session);

}  // namespace waymark::tools
