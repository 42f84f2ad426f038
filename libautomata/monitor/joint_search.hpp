// Is there a word that all of some automata accept, from the places that they have reached? Emptiness of their product
// on the fly.
//
// A successor of a tuple of states is found by choosing a move of each part, one after the other, whose cubes agree:
// the moves that accept soonest come first, so that the first successor is usually the best. Over infinite words,
// strongly connected components are merged along the depth-first path [Cou99], and one with all marks of all parts
// accepts. Over finite words, a tuple of accepting places does. The product is never built: automata with few
// propositions in common need a few steps, whatever their number.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/monitor/part.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

enum class Words : std::uint8_t { Finite, Infinite };  // that are read

struct JointAnswer {                                       // whether there is such a word
  enum class Verdict : std::uint8_t { No, Yes, Unknown };  // of the search
  Verdict verdict = Verdict::Unknown;                      // Unknown: a part has too many moves
  std::vector<ltl::Letter> letters = {};  // Yes: along these, all tuples have such a word; the first is for `from`
};

// One place for each part, none of them `nowhere`. One step of budget for each move that is tried; throws what the
// budget throws.
JointAnswer joint_word(std::span<Part* const> parts, const std::vector<Part::Place>& from, Words words, Budget& budget);

}  // namespace waymark::automata
