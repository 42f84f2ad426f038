// Propositions have structure: in which direction something is seen, what kind of thing it is, and which one.
//
//   left_chair = {Left, Object, "chair"}     blue = {Here, Floor, "blue"}      next_tee = {Next, NodeKind, "tee"}
//   turned_left = {Left, Event, "turned"}    moved = {Here, Event, "moved"}    place_3 = {Here, PlaceNumber, "3"}
// What each of them means is said in labelling.hpp. Names of propositions are made and read here alone.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "libltl/vocabulary.hpp"

namespace waymark::plan {

enum class Direction : std::uint8_t { Here, Ahead, Right, Behind, Left, Next };
enum class Kind : std::uint8_t {
  Event,     // of the action that leads to the pose
  Object,    // furniture
  Floor,     // a floor pattern
  Painting,  // on the walls of a hallway
  Passage,   // `wall` or `open`: whether there is a hallway
  NodeKind,  // by the number of ways: `intersection`, `corner`, …
  PlaceNumber
};

struct Observable {
  Direction direction = Direction::Here;
  Kind kind = Kind::Object;
  std::string name;
  friend bool operator==(const Observable&, const Observable&) = default;
};

// The words of the names: "ahead", "right", "behind", "left", "next"; "here" stands in no name.
const std::string& word_of(Direction direction);

std::string proposition_name(const Observable& observable);

// Left and right exchanged.
Observable mirrored(Observable observable);

// By proposition, of a hallway vocabulary or a part of one. What may be `next` is an object; what is seen but never
// stood at, a painting; everything else that is named, a floor or an object by itself.
// Throws std::invalid_argument naming a proposition that has none of the forms above.
std::vector<Observable> observables_of(const ltl::Vocabulary& vocabulary);

}  // namespace waymark::plan
