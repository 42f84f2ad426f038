// The operations and questions of `waymark automaton` about one automaton.
//
// A question is answered "yes", or "no" with a word that shows why. Two automata must both be about finite words or
// both about infinite ones.
#pragma once
#include <stop_token>
#include <string>
#include <variant>

#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/omega/automaton.hpp"
#include "tools/automaton_output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

using AnyAutomaton = std::variant<automata::Dfa, automata::Automaton>;

struct AutomatonRequest {
  std::string source;                           // of the first automaton
  std::string product, either, difference;      // files: the other automaton
  std::string equivalent, included, satisfies;  // files, and a formula
  std::string kind;                             // of automaton to make: tgba, buchi, parity, ldba
  bool complement = false, empty = false, universal = false, minimize = false, reduce = false;
  std::size_t states = 1'000'000;

  bool changes_language() const { return complement || !product.empty() || !either.empty() || !difference.empty(); }
  bool asks() const { return empty || universal || !equivalent.empty() || !included.empty(); }
};

// A DFA when the file says finite-words.
AnyAutomaton understood(automata::HoaAutomaton file, const std::string& source, automata::Budget& budget);
// All operations asked for, in a fixed order: complement, product, union, difference, reduction, change of kind.
AnyAutomaton transformed(AnyAutomaton any, const AutomatonRequest& request, automata::Budget& budget, Shown& about);
// Do all words that are accepted satisfy request.satisfies?
Reply satisfies(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget,
                std::stop_token stop);
// The one question of asks() that was asked.
Reply asked_of(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget);

}  // namespace waymark::tools
