// Propositions have structure: in which direction something is seen, what kind of thing it is, and which one.
//
//   left_chair = {Left, Object, "chair"}     blue = {Here, Floor, "blue"}      next_tee = {Next, NodeKind, "tee"}
//   turned_left = {Left, Event, "turned"}    moved = {Here, Event, "moved"}    place_3 = {Here, PlaceNumber, "3"}
// What each of them means is said in labelling.hpp, which also reads the names that are made here.
#pragma once
#include <cstdint>
#include <string>

namespace waymark::plan {

enum class Direction : std::uint8_t { Here, Ahead, Right, Behind, Left, Next };  // where something is seen
enum class Kind : std::uint8_t {                                                 // what is seen
  Event,                                                                         // of the action that leads to the pose
  Object,                                                                        // furniture
  Floor,                                                                         // a floor pattern
  Painting,                                                                      // on the walls of a hallway
  Passage,   // `wall` or `open`: whether there is a hallway
  NodeKind,  // by the number of ways: `intersection`, `corner`, …
  PlaceNumber
};

struct Observable {
  Direction direction = Direction::Here;  // of the thing, seen from the pose
  Kind kind = Kind::Object;               // of the thing
  std::string name;                       // of the thing
  friend bool operator==(const Observable&, const Observable&) = default;
};

// The words of the names: "ahead", "right", "behind", "left", "next"; "here" stands in no name.
const std::string& word_of(Direction direction);

std::string proposition_name(const Observable& observable);  // the inverse of reading a name

// Left and right exchanged.
Observable mirrored(Observable observable);

}  // namespace waymark::plan
