#include "libplan/world/observable_english.hpp"

#include <utility>

#include "libplan/world/labelling.hpp"

namespace waymark::plan {
namespace {

std::string side_of(Direction direction) {
  switch (direction) {
    case Direction::Here: return "here";
    case Direction::Ahead: return "ahead";
    case Direction::Right: return "to your right";
    case Direction::Behind: return "behind you";
    case Direction::Left: return "to your left";
    case Direction::Next: return "at the next place ahead";
  }
  return {};  // unreachable: -Werror=switch
}

}  // namespace

ltl::Described described(const Observable& observable) {
  const auto& [direction, kind, name] = observable;
  if (kind == Kind::Event)
    return ltl::event(direction == Direction::Here ? "go forward" : "turn " + word_of(direction));
  const std::string noun = noun_of(observable);
  if (direction == Direction::Here) return kind == Kind::Floor ? ltl::floor(noun) : ltl::place(noun);
  const std::string side = side_of(direction);
  if (kind == Kind::Passage || kind == Kind::NodeKind)
    return ltl::state("there is " + noun + ' ' + side, "there is not " + noun + ' ' + side);
  return ltl::state(noun + " is " + side, noun + " is not " + side);
}

std::function<ltl::Described(ltl::Proposition)> hallway_english(const ltl::Vocabulary& vocabulary) {
  return [observables = observables_of(vocabulary)](ltl::Proposition p) { return described(observables.at(p.index)); };
}

}  // namespace waymark::plan
