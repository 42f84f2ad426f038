#include "libparser/language/route_language.hpp"

#include <stdexcept>

namespace waymark::parser {
namespace {

Saying joined(Saying a, const std::string& between, const Saying& b) {
  a.text += between + b.text;
  a.program.insert(a.program.end(), b.program.begin(), b.program.end());
  a.clauses += b.clauses;
  return a;
}

}  // namespace

Speaker::Speaker(const plan::Map& map, Dialect dialect, std::uint64_t seed)
    : vocabulary_(map.vocabulary()), objects_(map.objects()), floors_(map.floors()), dialect_(dialect), random_(seed) {
  if (objects_.size() < 2 || floors_.empty())
    throw std::invalid_argument("sentences need a map that lists two objects and a floor");
}

Saying Speaker::say(std::size_t clauses) {
  Saying said = clause();
  while (said.clauses < clauses) {
    const std::string between =
        dialect_ == Dialect::Plain ? one_of({" and ", ", then "}) : one_of({" and ", ", then ", " and then "});
    said = joined(std::move(said), between, clause());
  }
  return said;
}

Saying Speaker::clause() {
  return dialect_ == Dialect::Plain || random_.below(2) == 0 ? plain_clause() : temporal_clause();
}

Saying Speaker::plain_clause() {
  switch (random_.below(6)) {
    case 0: return turn();
    case 1: return count();
    case 2: return to_landmark();
    case 3: return to_the_end();
    case 4: return face_floor();
    default: return until_beside();
  }
}

Saying Speaker::temporal_clause() {
  switch (random_.below(7)) {
    case 0: return past();
    case 1: return nth();
    case 2: return keeping();
    case 3: return avoiding();
    case 4: return before();
    case 5: return after();
    default: return conditional();
  }
}

Saying Speaker::turn() {
  const std::string side = one_of({"left", "right"}), verb = one_of({"turn ", "go ", "make a "});
  return {verb + side, {step(StepKind::Next, "turned_" + side)}, 1};
}

Saying Speaker::count() {
  const std::size_t k = 1 + random_.below(4);
  const char* const counts[] = {"one step", "two steps", "three steps", "four steps"};
  return {one_of({"walk forward ", "move ", "go "}) + counts[k - 1],
          {{StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}}},
          1};
}

Saying Speaker::to_landmark() {
  const std::string object = thing(objects_);
  return {one_of({"walk to the ", "go to the ", "move on to the "}) + object, {step(StepKind::Reach, object)}, 1};
}

Saying Speaker::to_the_end() {
  return {one_of({"go straight to the end of the hall", "follow the hall until it ends", "walk on to the wall"}),
          {step(StepKind::Advance, "ahead_wall")},
          1};
}

Saying Speaker::face_floor() {
  const std::string floor = thing(floors_);
  return {one_of({"face the ", "turn until you look along the "}) + floor + " hall",
          {step(StepKind::Face, "ahead_" + floor)},
          1};
}

Saying Speaker::until_beside() {
  const std::string object = thing(objects_), side = one_of({"left", "right"});
  return {one_of({"walk until the ", "go on until you see the "}) + object + " on your " + side,
          {step(StepKind::Advance, side + "_" + object)},
          1};
}

Saying Speaker::past() {
  const std::string object = thing(objects_), verb = one_of({"walk past the ", "go straight past the ", "pass the "});
  return {verb + object, {step(StepKind::Past, object)}, 1};
}

Saying Speaker::nth() {
  const std::size_t k = 2 + random_.below(2);
  const bool place = random_.below(2) == 0;
  const std::string what = place ? one_of({"intersection", "corner", "tee"}) : thing(objects_);
  const std::string verb = one_of({"walk to the ", "go straight to the ", "move on to the "});
  return {
      verb + (k == 2 ? "second " : "third ") + what, {step(StepKind::Advance, what, static_cast<std::uint8_t>(k))}, 1};
}

Saying Speaker::keeping() {
  const std::string object = thing(objects_);
  const std::string side = one_of({"left", "right"});
  if (random_.below(2) == 0)
    return {"keep the wall on your " + side + " until you reach the " + object,
            {step(StepKind::Keep, side + "_wall"), step(StepKind::Reach, object)},
            1};
  const std::string floor = thing(floors_);
  return {one_of({"stay on the ", "follow the "}) + floor + " floor until the " + object,
          {step(StepKind::Keep, floor), step(StepKind::Reach, object)},
          1};
}

Saying Speaker::avoiding() {
  const std::string object = thing(objects_);
  const bool floor = random_.below(2) == 0;
  const std::string what = floor ? thing(floors_) : other_thing(object);
  const std::string how = floor ? one_of({" without touching the ", " avoiding the "})
                                : one_of({" without passing the ", " avoiding the "});
  return {one_of({"go to the ", "walk to the "}) + object + how + what + (floor ? " floor" : ""),
          {step(StepKind::Without, what), step(StepKind::Reach, object)},
          1};
}

Saying Speaker::before() {
  const std::string first = thing(objects_), second = other_thing(first);
  return {one_of({"visit the ", "go to the "}) + first + " before the " + second,
          {step(StepKind::Without, second), step(StepKind::Reach, first), step(StepKind::Reach, second)},
          1};
}

Saying Speaker::after() {
  const std::string first = thing(objects_), second = other_thing(first);
  return {one_of({"visit the ", "go to the "}) + second + " after the " + first,
          {step(StepKind::Reach, first), step(StepKind::Reach, second)},
          1};
}

Saying Speaker::conditional() {
  const bool otherwise = random_.below(2) == 0;
  Saying said = condition(otherwise ? StepKind::Whether : StepKind::When);
  said = joined(std::move(said), ", ", short_clause());
  if (otherwise) said = joined(std::move(said), ", otherwise ", short_clause());
  said.clauses = otherwise ? 2 : 1;
  return said;
}

Saying Speaker::condition(StepKind kind) {
  const std::string side = one_of({"left", "right"});
  switch (random_.below(4)) {
    case 0: return {"if there is a wall ahead", {step(kind, "ahead_wall")}, 0};
    case 1: return {"if there is a wall on your " + side, {step(kind, side + "_wall")}, 0};
    case 2: {
      const std::string object = thing(objects_);
      return {"if you see the " + object + " on your " + side, {step(kind, side + "_" + object)}, 0};
    }
    default: {
      const std::string object = thing(objects_);
      return {"if the " + object + " is ahead", {step(kind, "ahead_" + object)}, 0};
    }
  }
}

Saying Speaker::short_clause() {
  switch (random_.below(4)) {
    case 0: return turn();
    case 1: return count();
    case 2: return to_landmark();
    default: return to_the_end();
  }
}

std::string Speaker::one_of(std::initializer_list<const char*> choices) {
  return *(choices.begin() + random_.below(choices.size()));
}

std::string Speaker::thing(const std::vector<std::string>& names) { return names[random_.below(names.size())]; }

std::string Speaker::other_thing(const std::string& but) {
  std::string name = thing(objects_);
  while (name == but) name = thing(objects_);
  return name;
}

Step Speaker::step(StepKind kind, const std::string& literal, std::uint8_t count) const {
  const auto p = vocabulary_.find(literal);
  if (!p) throw std::invalid_argument("generated instructions need the proposition '" + literal + "'");
  return {kind, count, 1, {static_cast<std::uint16_t>(p->index)}};
}

}  // namespace waymark::parser
