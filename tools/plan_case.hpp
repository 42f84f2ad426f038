// waymark plan --case and --model: every task of a planning case, or formulas on a model of any kind → values between
// proved bounds.
#pragma once
#include <string>

#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/shell/work_limits.hpp"

namespace waymark::tools {

struct CaseChoice {
  std::string file, task, method = "best";
  std::string model, query, automaton;  // --model; no query: pmax
  std::string strategy;                 // a file for it; empty: none
  std::string strategy_format = "waymark";
  std::string scheduler;         // a file to read: the model's choices; empty: they are free
  std::string order = "prefix";  // of lassos
  std::size_t top = 1;
  double discount = 0.9;
  double tolerance = 1e-6;
  WorkLimits limits;  // of each formula or task, and of reading a model
  bool json = false;
};
plan::LassoOrder order_of(const std::string& name);  // `order` of a choice
void add_case_options(Command command, CaseChoice& choice);
ExitCode plan_case(const CaseChoice& choice, const Session& session);
// --model of a choice within its seconds. Throws as plan::read_model, GaveUp and Interrupted.
plan::PlanningCase read_model(const CaseChoice& choice, const std::string& start, const std::stop_token& stop);
// Formulas, or the automaton that was chosen, on a model of any kind.
ExitCode plan_model(plan::PlanningCase model, const CaseChoice& choice, const TextOptions& formulas,
                    const Session& session);

}  // namespace waymark::tools
