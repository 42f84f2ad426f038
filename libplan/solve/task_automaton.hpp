// The automaton that answers the query of a task: finite where goals say it all, limit-deterministic otherwise.
//
// A task may come as an automaton in the place of a formula. What is asked of a Markov decision process needs an
// automaton whose choices do no harm there; a file proves nothing of the kind, so a nondeterministic one is
// determinised, whatever it claims.
#pragma once
#include <optional>
#include <string_view>
#include <variant>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"

namespace waymark::plan {

using TaskAutomaton = std::variant<automata::Dfa, automata::MdpSafe>;  // for finite tasks, for infinite ones

// Is the formula about finite words, or decided by a finite prefix of infinite ones where it holds?
bool is_finite_task(ltl::Formula f, CaseTask::Logic logic);

// What is asked for by a least cost over infinite words, or by a discounted reward, is a good prefix, whatever the
// formula; the least probability of a task that is not finite is that of its negation, which is left to the caller.
// nullopt: the limits were met.
std::optional<TaskAutomaton> task_automaton(ltl::Formula f, CaseTask::Logic logic, CaseTask::Query query,
                                            const ltl::Limits& limits);

// A task that came as an automaton: a DFA is about finite words, any other automaton about infinite ones.
using GivenAutomaton = std::variant<automata::Dfa, automata::Automaton>;

// HOA; what says `properties: finite-words` is a DFA. Throws ltl::FormatError.
GivenAutomaton read_given_automaton(std::string_view hoa, std::string_view source = "");

// As of a formula with the same words. The least probability of an infinite task is that of its complement: here the
// complement is returned. Throws std::invalid_argument for a query that such words do not have.
std::optional<TaskAutomaton> task_automaton(const GivenAutomaton& given, CaseTask::Query query,
                                            const ltl::Limits& limits);

// Of all other words. nullopt: the limits were met. Throws std::invalid_argument for a DFA: it says nothing of words
// without end.
std::optional<GivenAutomaton> complement(const GivenAutomaton& given, const ltl::Limits& limits);

// Generalised Büchi, for lassos on deterministic models. Throws std::invalid_argument for a DFA.
std::optional<automata::Automaton> lasso_automaton(ltl::Formula f, const ltl::Limits& limits);
std::optional<automata::Automaton> lasso_automaton(const GivenAutomaton& given, const ltl::Limits& limits);

}  // namespace waymark::plan
