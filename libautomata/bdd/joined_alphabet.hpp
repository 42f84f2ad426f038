// One alphabet for two automata, whose propositions are matched by name.
//
// An automaton names its propositions by a vocabulary, and variable v of its diagrams is the proposition reads[v]. Two
// automata that read one word need the same variables: every operation on two automata takes them from here.
#pragma once
#include <vector>

#include "libautomata/bdd/mtbdd.hpp"
#include "libltl/vocabulary.hpp"

namespace waymark::automata {

struct Alphabet {                              // of an automaton, which keeps it
  const ltl::Vocabulary& vocabulary;           // names
  const std::vector<ltl::Proposition>& reads;  // by variable
};

struct JoinedAlphabet {
  ltl::Vocabulary vocabulary;                   // that of the first, then the names that the second adds
  std::vector<ltl::Proposition> reads;          // what one of them reads, ascending
  std::vector<Mtbdd::Variable> of_first = {};   // by variable of the first: its new variable
  std::vector<Mtbdd::Variable> of_second = {};  // by variable of the second
};

JoinedAlphabet joined(const Alphabet& first, const Alphabet& second);  // O(propositions)

// The same functions in another manager, variable v renamed to name[v]; the order of variables may change.
std::vector<Mtbdd::Node> renamed(const Mtbdd& from, const std::vector<Mtbdd::Node>& roots,
                                 const std::vector<Mtbdd::Variable>& name, Mtbdd& to);

}  // namespace waymark::automata
