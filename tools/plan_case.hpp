// waymark plan --case and --model: every task of a planning case, or formulas on a model of any kind → values between
// proved bounds.
#pragma once
#include <string>

#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/case_task.hpp"
#include "tools/case_options.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/reply.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

ExitCode plan_case(const CaseChoice& choice, const Session& session);
// The answer as plan_case prints it, with its exit code.
Reply told(const std::string& case_name, const plan::CaseTask& task, const plan::CaseAnswer& answer, bool json);
// --model of a choice within its seconds. Throws as plan::read_model, GaveUp and Interrupted.
plan::PlanningCase read_model(const CaseChoice& choice, const std::string& start, const std::stop_token& stop);
// Formulas, or the automaton that was chosen, on a model of any kind.
ExitCode plan_model(plan::PlanningCase model, const CaseChoice& choice, const TextOptions& formulas,
                    const Session& session);

}  // namespace waymark::tools
