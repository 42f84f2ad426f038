#include "libplan/world/observable.hpp"

#include <array>
#include <cstddef>

namespace waymark::plan {
namespace {

const std::array<std::string, 6> words{"here", "ahead", "right", "behind", "left", "next"};

}  // namespace

const std::string& word_of(Direction direction) { return words.at(static_cast<std::size_t>(direction)); }

std::string proposition_name(const Observable& observable) {
  const auto& [direction, kind, name] = observable;
  if (kind == Kind::PlaceNumber) return "place_" + name;
  if (direction == Direction::Here) return name;
  if (kind == Kind::Event) return name + "_" + word_of(direction);
  return word_of(direction) + "_" + name;
}

Observable mirrored(Observable observable) {
  if (observable.direction == Direction::Left)
    observable.direction = Direction::Right;
  else if (observable.direction == Direction::Right)
    observable.direction = Direction::Left;
  return observable;
}

}  // namespace waymark::plan
