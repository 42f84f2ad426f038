// The DFA of an automaton on infinite words whose accepted words are all settled by a finite prefix: a co-safe
// language.
#pragma once
#include <variant>

#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

struct UnsettledWord {         // accepted, although no prefix of it settles that
  ltl::Lasso word;             // over `vocabulary`
  ltl::Vocabulary vocabulary;  // of the automaton
};

// The finite words after which every continuation is accepted, minimal; or a word that no such prefix begins. Throws
// what the budget throws.
std::variant<Dfa, UnsettledWord> good_prefixes(const Automaton& automaton, Budget& budget);

}  // namespace waymark::automata
