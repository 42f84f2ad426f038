#include "libplan/solve/task_automaton.hpp"

#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libautomata/deterministic/parity.hpp"
#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/monitor/monitor.hpp"
#include "libautomata/omega/without_fin.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/fragment.hpp"

namespace waymark::plan {
namespace {

using Query = CaseTask::Query;
using automata::Automaton;
using automata::Budget;

template <class Result>
auto* found(Result& result) {
  return std::get_if<0>(&result);
}

// The same over infinite words, where N is X, with strong nexts only, ↔ expanded. Read on a finite word a weak next, or
// a strong one under a negation, is satisfied by the end of the word, of which infinite words know nothing.
ltl::Formula with_strong_nexts(ltl::Formula f) {
  using ltl::Op;
  const ltl::Formula normal = ltl::nnf(f);
  std::unordered_map<ltl::Formula, ltl::Formula> image;
  for (ltl::Formula g : ltl::subformulas(normal)) {
    std::vector<ltl::Formula> parts;
    for (ltl::Formula operand : g.operands()) parts.push_back(image.at(operand));
    const auto made = [&] {
      switch (g.op()) {
        case Op::And: return ltl::conjunction(g.arena(), parts);
        case Op::Or: return ltl::disjunction(g.arena(), parts);
        case Op::Next:
        case Op::WeakNext: return ltl::next(parts[0]);
        case Op::Until: return ltl::until(parts[0], parts[1]);
        case Op::Release: return ltl::release(parts[0], parts[1]);
        case Op::Yesterday: return ltl::yesterday(parts[0]);
        case Op::Since: return ltl::since(parts[0], parts[1]);
        case Op::False:
        case Op::True:
        case Op::Atom:
        case Op::Not:
        case Op::Iff: break;  // of literals, and not in a normal form
      }
      return g;
    };
    image.emplace(g, made());
  }
  return image.at(normal);
}

bool asks_for_prefix(Query query) {
  return query == Query::MinCost || query == Query::MaxCost || query == Query::Discounted;
}

// Runs a construction that may run out of budget.
template <class Construct>
auto within(const ltl::Limits& limits, const Construct& construct)
    -> std::optional<decltype(construct(std::declval<Budget&>()))> {
  try {
    Budget budget(SIZE_MAX, limits.states, limits.stop);
    return construct(budget);
  } catch (const Budget::Exceeded&) {
    return std::nullopt;
  }
}

Automaton complement_of(const Automaton& automaton, Budget& budget) {
  return automata::complement(automata::determinized(automaton, budget)).automaton();
}

// The finite words of which every continuation is accepted.
automata::Dfa good_prefixes(const Automaton& automaton, Budget& budget) {
  const Automaton rest = complement_of(automaton, budget);
  return automata::bad_prefixes(
      automata::as_automaton(automata::trim(rest.transitions()), rest.vocabulary(), rest.reads()), budget);
}

}  // namespace

bool is_finite_task(ltl::Formula f, CaseTask::Logic logic) {
  if (logic != CaseTask::Logic::Ltl) return true;
  // The normal form in which with_strong_nexts replaces nexts keeps those below a negated past operator as they are.
  const ltl::Fragments of = ltl::fragments(f, ltl::Semantics::Infinite);
  return of.cosafety && (of.next_free || !ltl::has_past(f));
}

std::optional<TaskAutomaton> task_automaton(ltl::Formula f, CaseTask::Logic logic, CaseTask::Query query,
                                            const ltl::Limits& limits) {
  const bool finite = is_finite_task(f, logic);
  if (asks_for_prefix(query) && logic == CaseTask::Logic::Ltl &&
      !(finite && ltl::fragments(f, ltl::Semantics::Infinite).next_free)) {
    auto monitor = automata::ltl_to_monitor(f, limits);
    if (auto* done = found(monitor)) return done->good();
  } else if (finite) {
    auto dfa = automata::ltlf_to_dfa(logic == CaseTask::Logic::Ltl ? with_strong_nexts(f) : f, limits);
    if (auto* done = found(dfa)) return std::move(*done);
  } else {
    auto ldba = automata::ltl_to_ldba(f, limits);
    if (auto* done = found(ldba)) return std::move(done->automaton);
  }
  return std::nullopt;
}

GivenAutomaton read_given_automaton(std::string_view hoa, std::string_view source) {
  automata::HoaAutomaton file = automata::parse_hoa(hoa, source);
  for (const automata::HoaToken& property : file.properties)
    if (property.text == "finite-words") return automata::to_dfa(std::move(file), source);
  Budget budget;
  return automata::to_automaton(std::move(file), source, budget);
}

std::optional<TaskAutomaton> task_automaton(const GivenAutomaton& given, Query query, const ltl::Limits& limits) {
  if (const auto* dfa = std::get_if<automata::Dfa>(&given)) return *dfa;
  if (query == Query::MinSteps)
    throw std::invalid_argument("query steps is about finite words, the automaton about infinite ones");
  const Automaton& automaton = std::get<Automaton>(given);
  if (asks_for_prefix(query))
    return within(limits, [&](Budget& budget) -> TaskAutomaton { return good_prefixes(automaton, budget); });
  return within(limits, [&](Budget& budget) -> TaskAutomaton {
    return automata::limit_deterministic(
        automata::to_parity(query == Query::MinProbability ? complement_of(automaton, budget) : automaton, budget));
  });
}

std::optional<GivenAutomaton> complement(const GivenAutomaton& given, const ltl::Limits& limits) {
  const auto* automaton = std::get_if<Automaton>(&given);
  if (automaton == nullptr)
    throw std::invalid_argument("a run of a model is an infinite word, the automaton is about finite ones");
  return within(limits, [&](Budget& budget) -> GivenAutomaton { return complement_of(*automaton, budget); });
}

std::optional<Automaton> lasso_automaton(ltl::Formula f, const ltl::Limits& limits) {
  auto made = automata::ltl_to_tgba(f, limits);
  if (auto* done = found(made)) return std::move(done->automaton);
  return std::nullopt;
}

std::optional<Automaton> lasso_automaton(const GivenAutomaton& given, const ltl::Limits& limits) {
  const auto* automaton = std::get_if<Automaton>(&given);
  if (automaton == nullptr)
    throw std::invalid_argument("a lasso is an infinite word, the automaton is about finite ones");
  return within(limits, [&](Budget& budget) {
    return automata::as_automaton(automata::without_fin(automaton->transitions(), budget), automaton->vocabulary(),
                                  automaton->reads());
  });
}

}  // namespace waymark::plan
