#include "libplan/world/labelling.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waymark::plan {
namespace {

using Names = std::vector<std::string>;

constexpr std::array<Direction, 4> directions{Direction::Ahead, Direction::Right, Direction::Behind,
                                              Direction::Left};  // clockwise from the heading

// What a node is, by the number of its open ways.
Names node_kinds_of(const Hallways& hallways, std::uint32_t node) {
  std::vector<int> ways;
  for (int heading = 0; heading < 360; heading += 90)
    if (hallways.hallway(node, heading) != nullptr) ways.push_back(heading);
  switch (ways.size()) {
    case 0: return {};
    case 1: return {"dead_end"};
    case 2: return {ways[1] - ways[0] == 180 ? "corridor" : "corner"};
    case 3: return {"tee", "intersection"};
    default: return {"intersection"};
  }
}

Names floor_of(const Edge* way) { return way == nullptr || way->floor.empty() ? Names() : Names{way->floor}; }

Names floors_at(const Hallways& hallways, std::uint32_t node) {
  Names out;
  for (int heading = 0; heading < 360; heading += 90)
    for (std::string& floor : floor_of(hallways.hallway(node, heading))) out.push_back(std::move(floor));
  return out;
}

Names object_at(const Hallways& hallways, std::uint32_t node) {
  const auto& object = hallways.nodes()[node].object;
  return object ? Names{*object} : Names();
}

Names place_at(const Hallways& hallways, std::uint32_t node) {
  const auto& place = hallways.nodes()[node].place;
  return place ? Names{std::to_string(*place)} : Names();
}

Names places(const Observables& observables) {
  Names out;
  for (int number = 1; number <= observables.places; ++number) out.push_back(std::to_string(number));
  return out;
}

// A kind of proposition of poses: which names there are, and which of them hold where.
struct KindOfPose {
  Kind kind;
  Names (*names)(const Observables&);                      // of empty observables: those that every map has
  Names (*here)(const Hallways&, std::uint32_t node);      // of a node; nullptr: there are none
  bool next;                                               // the names of the node one step ahead are propositions
  bool seen;                                               // the names seen in the four directions are propositions
  Names (*way)(const Edge*);                               // of a hallway, or of no hallway; nullptr: there are none
  std::string (*noun)(const std::string& name) = nullptr;  // in English; nullptr: "the NAME"
};

const std::array<KindOfPose, 6> kinds_of_poses{{
    {Kind::Object, [](const Observables& o) { return o.objects; }, object_at, true, true, nullptr},
    {Kind::Floor, [](const Observables& o) { return o.floors; }, floors_at, false, true, floor_of,
     [](const std::string& name) { return "the " + name + " floor"; }},
    {Kind::NodeKind,
     [](const Observables&) {
       return Names{"intersection", "corner", "tee", "corridor", "dead_end"};
     },
     node_kinds_of, true, false, nullptr,
     [](const std::string& name) { return (name.starts_with('i') ? "an " : "a ") + name; }},
    {Kind::Painting, [](const Observables& o) { return o.walls; }, nullptr, false, true,
     [](const Edge* way) { return way == nullptr || way->wall.empty() ? Names() : Names{way->wall}; },
     [](const std::string& name) { return "the " + name + " painting"; }},
    {Kind::Passage,
     [](const Observables&) {
       return Names{"wall", "open"};
     },
     nullptr, false, true, [](const Edge* way) { return Names{way == nullptr ? "wall" : "open"}; },
     [](const std::string& name) -> std::string { return name == "wall" ? "a wall" : "an open way"; }},
    {Kind::PlaceNumber, places, place_at, false, false, nullptr,
     [](const std::string& name) { return "place " + name; }},
}};

bool is_among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// What is named after the direction.
Kind kind_of(const std::string& name, Direction direction, const ltl::Vocabulary& vocabulary) {
  const bool seen = direction != Direction::Here && direction != Direction::Next;
  const auto fixed = std::find_if(kinds_of_poses.begin(), kinds_of_poses.end(),
                                  [&](const KindOfPose& kind) { return is_among(kind.names({}), name); });
  const bool is_fixed = fixed != kinds_of_poses.end();
  if (name.empty() || (is_fixed && !seen && fixed->here == nullptr))
    throw std::invalid_argument("'" + proposition_name({direction, Kind::Object, name}) +
                                "' is no proposition of a hallway map");
  if (is_fixed) return fixed->kind;
  if (vocabulary.find(proposition_name({Direction::Next, Kind::Object, name}))) return Kind::Object;
  if (!vocabulary.find(name)) return Kind::Painting;
  return vocabulary.find(proposition_name({Direction::Ahead, Kind::Floor, name})) ? Kind::Floor : Kind::Object;
}

Observable observable_of(const std::string& proposition, const ltl::Vocabulary& vocabulary) {
  if (proposition == "moved") return {Direction::Here, Kind::Event, proposition};
  if (proposition.starts_with("place_") && is_number(proposition.substr(6)))
    return {Direction::Here, Kind::PlaceNumber, proposition.substr(6)};
  for (const Direction side : {Direction::Left, Direction::Right})
    if (Observable event{side, Kind::Event, "turned"}; proposition_name(event) == proposition) return event;
  Observable out{Direction::Here, Kind::Object, proposition};
  for (const Direction direction :
       {Direction::Ahead, Direction::Right, Direction::Behind, Direction::Left, Direction::Next})
    if (const std::string prefix = word_of(direction) + "_"; proposition.starts_with(prefix))
      out = {direction, Kind::Object, proposition.substr(prefix.size())};
  out.kind = kind_of(out.name, out.direction, vocabulary);
  return out;
}

// Inserts propositions; one the vocabulary lacks is an error.
class Writer {
 public:
  Writer(const ltl::Vocabulary& vocabulary, ltl::Letter& letter) : vocabulary_(vocabulary), letter_(letter) {}
  void add(Direction direction, Kind kind, const Names& names) {
    for (const std::string& name : names) {
      const auto p = vocabulary_.find(proposition_name({direction, kind, name}));
      if (!p) throw std::invalid_argument("the map shows '" + name + "', which it does not list");
      letter_.insert(*p);
    }
  }

 private:
  const ltl::Vocabulary& vocabulary_;
  ltl::Letter& letter_;
};

}  // namespace

ltl::Vocabulary hallway_vocabulary(const Observables& observables) {
  ltl::Vocabulary vocabulary;
  const auto add = [&](Direction direction, Kind kind, const Names& names) {
    for (const std::string& what : names) {
      const std::string name = proposition_name({direction, kind, what});
      if (what.empty()) throw std::invalid_argument("an observable needs a name");
      if (vocabulary.find(name))
        throw std::invalid_argument("two observables would share the proposition '" + name + "'");
      vocabulary.add(name);
    }
  };
  const auto add_kinds = [&](Direction direction, const auto& has) {
    for (const KindOfPose& kind : kinds_of_poses)
      if (has(kind)) add(direction, kind.kind, kind.names(observables));
  };
  add(Direction::Here, Kind::Event, {"moved"});
  for (const Direction side : {Direction::Left, Direction::Right}) add(side, Kind::Event, {"turned"});
  const auto is_place = [](const KindOfPose& kind) { return kind.kind == Kind::PlaceNumber; };
  add_kinds(Direction::Here, [&](const KindOfPose& kind) { return kind.here != nullptr && !is_place(kind); });
  for (const Direction direction : directions) add_kinds(direction, [](const KindOfPose& kind) { return kind.seen; });
  add_kinds(Direction::Next, [](const KindOfPose& kind) { return kind.next; });
  add_kinds(Direction::Here, is_place);
  return vocabulary;
}

std::string noun_of(const Observable& observable) {
  std::string name = observable.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  const auto kind = std::find_if(kinds_of_poses.begin(), kinds_of_poses.end(),
                                 [&](const KindOfPose& k) { return k.kind == observable.kind; });
  return kind == kinds_of_poses.end() || kind->noun == nullptr ? "the " + name : kind->noun(name);
}

std::vector<Observable> observables_of(const ltl::Vocabulary& vocabulary) {
  std::vector<Observable> out;
  for (const std::string& name : vocabulary.names()) out.push_back(observable_of(name, vocabulary));
  return out;
}

// What is seen from a node is what is seen from the next one on, and the object there: nodes are taken in order from
// the far end of every hallway, so that each is looked at once however long the hallway.
Labelling::Labelling(const Hallways& hallways, const ltl::Vocabulary& vocabulary)
    : hallways_(&hallways), vocabulary_(&vocabulary), sights_(hallways.nodes().size()) {
  std::vector<std::uint32_t> south_east_first(hallways.nodes().size());
  std::iota(south_east_first.begin(), south_east_first.end(), 0U);
  std::sort(south_east_first.begin(), south_east_first.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Node &left = hallways.nodes()[a], &right = hallways.nodes()[b];
    return std::pair(left.x, left.y) > std::pair(right.x, right.y);
  });
  const auto look = [&](std::uint32_t node, std::size_t quarter) {
    const auto next = hallways.neighbour(node, static_cast<int>(quarter) * 90);
    if (!next) return;
    ltl::Letter& sight = sights_[node][quarter];
    sight = sights_[*next][quarter];
    const auto& object = hallways.nodes()[*next].object;
    if (const auto p = object ? vocabulary.find(*object) : std::nullopt) sight.insert(*p);
  };
  for (std::uint32_t node : south_east_first)
    for (std::size_t quarter : {1U, 2U}) look(node, quarter);
  for (auto node = south_east_first.rbegin(); node != south_east_first.rend(); ++node)
    for (std::size_t quarter : {0U, 3U}) look(*node, quarter);
}

ltl::Letter Labelling::label(std::uint32_t node, int heading) const {
  ltl::Letter letter;
  Writer writer(*vocabulary_, letter);
  const auto next = hallways_->neighbour(node, heading);
  for (const KindOfPose& kind : kinds_of_poses) {
    if (kind.here != nullptr) writer.add(Direction::Here, kind.kind, kind.here(*hallways_, node));
    if (kind.next && next) writer.add(Direction::Next, kind.kind, kind.here(*hallways_, *next));
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const int looking = (heading + 90 * static_cast<int>(i)) % 360;
    const Edge* const way = hallways_->hallway(node, looking);
    for (const KindOfPose& kind : kinds_of_poses)
      if (kind.way != nullptr) writer.add(directions[i], kind.kind, kind.way(way));
    for (ltl::Proposition object : sights_[node][static_cast<std::size_t>(looking) / 90].members())
      writer.add(directions[i], Kind::Object, {vocabulary_->name(object)});
  }
  return letter;
}

}  // namespace waymark::plan
