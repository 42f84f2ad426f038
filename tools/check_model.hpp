// `waymark check φ --model FILE`: does every run of a model satisfy the formula? Else a counterexample.
#pragma once
#include <cstddef>
#include <string>

#include "tools/shell/input.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/shell/work_limits.hpp"

namespace waymark::tools {

struct CheckModelOptions {
  std::string model, start, constants;  // --model, --start, --const
  std::string rewards, automaton;       // --rewards; --automaton in the place of formulas
  std::size_t paths = 10;               // of a counterexample where chance decides
  WorkLimits limits;                    // of a formula
  bool json = false;
};
// The options but --start and --json, which are those of the caller.
void add_check_model_options(Command command, CheckModelOptions& options);

// Of every formula, or of the automaton: 0 where it holds, 10 with a counterexample.
ExitCode check_on_model(const CheckModelOptions& options, TextReader& formulas, const Session& session);
ExitCode check_automaton_on_model(const CheckModelOptions& options, const Session& session);

}  // namespace waymark::tools
