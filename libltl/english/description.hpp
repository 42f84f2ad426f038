// What English calls the propositions of a formula.
//
// A description of p has a clause for "p is in the letter", one for "p is not", and, where p is something that a robot
// does or a place where it goes, the imperatives for it. Empty texts mean that English has no such words for p.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/meaning/semantics.hpp"

namespace waymark::ltl {

struct Described {
  std::string holds, fails;  // "you are at the chair", "you are not at the chair"
  std::string reach = {};    // "go to the chair": the order to make p hold at some time
  std::string enter = {};    // "step on the blue floor": what "never" forbids
  std::string act = {};      // "turn left": of an event, the order to make it the next step
};

Described symbol(std::string_view name);                // "p holds", "p does not hold"
Described place(const std::string& noun);               // of "the chair"
Described floor(const std::string& noun);               // of "the blue floor"
Described event(const std::string& action);             // of "turn left": "you turn left", "you do not turn left"
Described state(std::string holds, std::string fails);  // clauses only: nothing can be done about p

struct VerbaliseOptions {                               // how formulas become English
  Semantics semantics = Semantics::Finite;              // the words that the formula is about
  std::function<Described(Proposition)> describe = {};  // nothing: all propositions are symbols
};

// The description of each proposition of the vocabulary, in its order.
std::vector<Described> described(const Vocabulary& vocabulary, const VerbaliseOptions& options);

}  // namespace waymark::ltl
