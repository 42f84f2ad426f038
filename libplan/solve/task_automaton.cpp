#include "libplan/solve/task_automaton.hpp"

#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/omega/monitor.hpp"
#include "libltl/fragment.hpp"

namespace waymark::plan {
namespace {

template <class Result>
auto* found(Result& result) {
  return std::get_if<0>(&result);
}

}  // namespace

bool is_finite_task(ltl::Formula f, CaseTask::Logic logic) {
  return logic != CaseTask::Logic::Ltl || ltl::fragments(f, ltl::Semantics::Infinite).cosafety;
}

std::optional<TaskAutomaton> task_automaton(ltl::Formula f, CaseTask::Logic logic, CaseTask::Query query,
                                            const automata::TranslationLimits& limits) {
  const bool finite = is_finite_task(f, logic);
  if (query == CaseTask::Query::MinCost && logic == CaseTask::Logic::Ltl &&
      !(finite && ltl::fragments(f, ltl::Semantics::Infinite).next_free)) {
    auto monitor = automata::ltl_to_monitor(f, limits);
    if (auto* done = found(monitor)) return done->good();
  } else if (finite) {
    auto dfa = automata::ltlf_to_dfa(f, limits);
    if (auto* done = found(dfa)) return std::move(*done);
  } else {
    auto ldba = automata::ltl_to_ldba(f, limits);
    if (auto* done = found(ldba)) return std::move(done->automaton);
  }
  return std::nullopt;
}

}  // namespace waymark::plan
