#include "libplan/world/labelling.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>

#include "libplan/world/observable.hpp"

namespace waymark::plan {
namespace {

constexpr std::array<std::string_view, 5> kinds{"intersection", "corner", "tee", "corridor", "dead_end"};
constexpr std::array<Direction, 4> directions{Direction::Ahead, Direction::Right, Direction::Behind,
                                              Direction::Left};  // clockwise from the heading

// Which kinds of place a node is, by the number of its open ways.
std::vector<std::string_view> kinds_of(const Hallways& hallways, std::uint32_t node) {
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

// Inserts propositions; one the vocabulary lacks is an error.
class Writer {
 public:
  Writer(const ltl::Vocabulary& vocabulary, ltl::Letter& letter) : vocabulary_(vocabulary), letter_(letter) {}
  void add(Direction direction, Kind kind, std::string_view name) {
    const auto p = vocabulary_.find(proposition_name({direction, kind, std::string(name)}));
    if (!p) throw std::invalid_argument("the map shows '" + std::string(name) + "', which it does not list");
    letter_.insert(*p);
  }

 private:
  const ltl::Vocabulary& vocabulary_;
  ltl::Letter& letter_;
};

void write_here(const Hallways& hallways, std::uint32_t node, Writer& writer) {
  const Node& here = hallways.nodes()[node];
  if (here.object) writer.add(Direction::Here, Kind::Object, *here.object);
  if (here.place) writer.add(Direction::Here, Kind::PlaceNumber, std::to_string(*here.place));
  for (std::string_view kind : kinds_of(hallways, node)) writer.add(Direction::Here, Kind::NodeKind, kind);
  for (int heading = 0; heading < 360; heading += 90) {
    const Edge* way = hallways.hallway(node, heading);
    if (way != nullptr && !way->floor.empty()) writer.add(Direction::Here, Kind::Floor, way->floor);
  }
}

// `sight`: the objects along the hallway that way, by their bare propositions.
void write_seen(const Hallways& hallways, std::uint32_t node, int heading, Direction direction,
                const ltl::Letter& sight, const ltl::Vocabulary& vocabulary, Writer& writer) {
  const Edge* way = hallways.hallway(node, heading);
  writer.add(direction, Kind::Passage, way == nullptr ? "wall" : "open");
  if (way == nullptr) return;
  if (!way->floor.empty()) writer.add(direction, Kind::Floor, way->floor);
  if (!way->wall.empty()) writer.add(direction, Kind::Painting, way->wall);
  for (ltl::Proposition object : sight.members())
    writer.add(direction, Kind::Object, vocabulary.name(object));
}

void write_next(const Hallways& hallways, std::uint32_t node, int heading, Writer& writer) {
  const auto next = hallways.neighbour(node, heading);
  if (!next) return;
  if (hallways.nodes()[*next].object)
    writer.add(Direction::Next, Kind::Object, *hallways.nodes()[*next].object);
  for (std::string_view kind : kinds_of(hallways, *next)) writer.add(Direction::Next, Kind::NodeKind, kind);
}

}  // namespace

ltl::Vocabulary hallway_vocabulary(const Observables& observables) {
  ltl::Vocabulary vocabulary;
  const auto add = [&](Direction direction, Kind kind, std::string_view what) {
    const std::string name = proposition_name({direction, kind, std::string(what)});
    if (what.empty()) throw std::invalid_argument("an observable needs a name");
    if (vocabulary.find(name))
      throw std::invalid_argument("two observables would share the proposition '" + name + "'");
    vocabulary.add(name);
  };
  const auto add_all = [&](Direction direction, Kind kind, const auto& names) {
    for (const auto& name : names) add(direction, kind, name);
  };
  add(Direction::Here, Kind::Event, "moved");
  for (const Direction side : {Direction::Left, Direction::Right}) add(side, Kind::Event, "turned");
  add_all(Direction::Here, Kind::Object, observables.objects);
  add_all(Direction::Here, Kind::Floor, observables.floors);
  add_all(Direction::Here, Kind::NodeKind, kinds);
  for (const Direction direction : directions) {
    add_all(direction, Kind::Object, observables.objects);
    add_all(direction, Kind::Floor, observables.floors);
    add_all(direction, Kind::Painting, observables.walls);
    add_all(direction, Kind::Passage, std::array<std::string_view, 2>{"wall", "open"});
  }
  add_all(Direction::Next, Kind::Object, observables.objects);
  add_all(Direction::Next, Kind::NodeKind, kinds);
  for (int number = 1; number <= observables.places; ++number)
    add(Direction::Here, Kind::PlaceNumber, std::to_string(number));
  return vocabulary;
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
  write_here(*hallways_, node, writer);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const int looking = (heading + 90 * static_cast<int>(i)) % 360;
    const ltl::Letter& sight = sights_[node][static_cast<std::size_t>(looking) / 90];
    write_seen(*hallways_, node, looking, directions[i], sight, *vocabulary_, writer);
  }
  write_next(*hallways_, node, heading, writer);
  return letter;
}

}  // namespace waymark::plan
