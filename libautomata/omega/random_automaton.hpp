// Random automata for testing this and other tools. The same seed gives the same automaton on every machine.
#pragma once
#include "libautomata/omega/automaton.hpp"
#include "libltl/structure/random.hpp"

namespace waymark::automata {

struct RandomAutomaton {
  std::uint32_t states = 4;  // at most: those that cannot be reached are dropped
  std::size_t atoms = 2;     // the first propositions of the vocabulary are read
  std::uint32_t sets = 2;    // acceptance sets
  std::size_t branches = 2;  // of a choice, at most; 1: deterministic
  double marked = 0.3;       // chance of each mark on each branch
  double empty = 0.1;        // chance that a choice is empty
  bool generic = true;       // a random condition over the sets; else generalised Büchi
};

// Throws std::invalid_argument when the options allow no automaton.
Automaton random_automaton(ltl::Random& random, const ltl::Vocabulary& vocabulary, const RandomAutomaton& options = {});

}  // namespace waymark::automata
