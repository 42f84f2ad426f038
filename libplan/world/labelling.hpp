// The labelling function of hallway maps, with every observable of instructions:
//
//   here         chair · blue (a floor that meets this place) · intersection corner tee corridor dead_end · place_3
//   seen         ahead_X left_X right_X behind_X   X: object (anywhere along the straight hallway), floor or
//                painting (of the next segment), `wall` (no hallway there), `open` (a hallway)
//   one step on  next_X   X: object or kind of place at the node one step ahead
//   events       moved turned_left turned_right, added by the action
// corridor: two ways in line; corner: two not in line; tee: three; intersection: three or more; dead_end: one.
// The view along the hallway starts at the next node: an object at this node is not `ahead`.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/world/hallways.hpp"
#include "libplan/world/observable.hpp"

namespace waymark::plan {

struct Observables {                 // what can be seen on a map; the order is the order of the vocabulary
  std::vector<std::string> objects;  // furniture
  std::vector<std::string> floors;   // floor patterns
  std::vector<std::string> walls;    // paintings on walls
  int places = 0;                    // places 1 … places
};

// The vocabulary of a hallway map with these observables. The three SAIL maps share one, so that formulas and models
// carry over. Throws std::invalid_argument when two observables would share one proposition (a floor named like an
// object, an object named `corner`), or on an empty name.
ltl::Vocabulary hallway_vocabulary(const Observables& observables);

// By proposition, of a hallway vocabulary or a part of one. What may be `next` is an object; what is seen but never
// stood at, a painting; everything else that is named, a floor or an object by itself.
// Throws std::invalid_argument naming a proposition that has none of the forms above.
std::vector<Observable> observables_of(const ltl::Vocabulary& vocabulary);

// What is seen, in English, without its direction: `the blue floor`, `an intersection`, `place 3`.
std::string noun_of(const Observable& observable);

// L over hallway_vocabulary, without events. Hallways and vocabulary must outlive the object.
class Labelling {
 public:
  // Looks along every hallway once. O(nodes · |objects|).
  Labelling(const Hallways& hallways, const ltl::Vocabulary& vocabulary);

  // L(node, heading). Throws std::invalid_argument naming an object, floor, painting or place that is unknown.
  ltl::Letter label(std::uint32_t node, int heading) const;

 private:
  const Hallways* hallways_;
  const ltl::Vocabulary* vocabulary_;
  std::vector<std::array<ltl::Letter, 4>> sights_;  // by node and heading / 90: the objects along the hallway
};

}  // namespace waymark::plan
