#include "libplan/world/observable.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace waymark::plan {
namespace {

const std::array<std::string, 6> words{"here", "ahead", "right", "behind", "left", "next"};
constexpr std::string_view place = "place_", turned = "turned";
constexpr std::array<std::string_view, 5> node_kinds{"intersection", "corner", "tee", "corridor", "dead_end"};
constexpr std::array<std::string_view, 2> passages{"wall", "open"};

template <class Names>
bool is_among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// What is named after the direction.
Kind kind_of(const std::string& name, Direction direction, const ltl::Vocabulary& vocabulary) {
  const bool passage = is_among(passages, name),
             seen = direction != Direction::Here && direction != Direction::Next;
  if (name.empty() || (passage && !seen))
    throw std::invalid_argument("'" + proposition_name({direction, Kind::Object, name}) +
                                "' is no proposition of a hallway map");
  if (passage) return Kind::Passage;
  if (is_among(node_kinds, name)) return Kind::NodeKind;
  if (vocabulary.find(proposition_name({Direction::Next, Kind::Object, name}))) return Kind::Object;
  if (!vocabulary.find(name)) return Kind::Painting;
  return vocabulary.find(proposition_name({Direction::Ahead, Kind::Floor, name})) ? Kind::Floor
                                                                                  : Kind::Object;
}

Observable observable_of(const std::string& proposition, const ltl::Vocabulary& vocabulary) {
  if (proposition == "moved") return {Direction::Here, Kind::Event, proposition};
  if (proposition.starts_with(place) && is_number(proposition.substr(place.size())))
    return {Direction::Here, Kind::PlaceNumber, proposition.substr(place.size())};
  for (const Direction side : {Direction::Left, Direction::Right})
    if (Observable event{side, Kind::Event, std::string(turned)}; proposition_name(event) == proposition)
      return event;
  Observable out{Direction::Here, Kind::Object, proposition};
  for (const Direction direction :
       {Direction::Ahead, Direction::Right, Direction::Behind, Direction::Left, Direction::Next})
    if (const std::string prefix = word_of(direction) + "_"; proposition.starts_with(prefix))
      out = {direction, Kind::Object, proposition.substr(prefix.size())};
  out.kind = kind_of(out.name, out.direction, vocabulary);
  return out;
}

}  // namespace

const std::string& word_of(Direction direction) { return words.at(static_cast<std::size_t>(direction)); }

std::string proposition_name(const Observable& observable) {
  const auto& [direction, kind, name] = observable;
  if (kind == Kind::PlaceNumber) return std::string(place) + name;
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

std::vector<Observable> observables_of(const ltl::Vocabulary& vocabulary) {
  std::vector<Observable> out;
  for (const std::string& name : vocabulary.names()) out.push_back(observable_of(name, vocabulary));
  return out;
}

}  // namespace waymark::plan
