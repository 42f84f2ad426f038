// The automaton that answers the query of a task: finite where goals say it all, limit-deterministic otherwise.
#pragma once
#include <optional>
#include <variant>

#include "libautomata/dfa.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"
#include "libautomata/ltlf_to_dfa.hpp"
#include "libltl/formula.hpp"
#include "libplan/model/read_case.hpp"

namespace waymark::plan {

using TaskAutomaton = std::variant<automata::Dfa, automata::MdpSafe>;

// Is the formula about finite words, or decided by a finite prefix of infinite ones where it holds?
bool is_finite_task(ltl::Formula f, CaseTask::Logic logic);

// What is asked for by a least cost over infinite words is a good prefix, whatever the formula; the least probability
// of a task that is not finite is that of its negation, which is left to the caller. nullopt: the limits were met.
std::optional<TaskAutomaton> task_automaton(ltl::Formula f, CaseTask::Logic logic, CaseTask::Query query,
                                            const automata::TranslationLimits& limits);

}  // namespace waymark::plan
