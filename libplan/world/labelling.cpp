#include "libplan/world/labelling.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string_view>

namespace waymark::plan {
namespace {

constexpr std::array<std::string_view, 5> kinds{"intersection", "corner", "tee", "corridor", "dead_end"};
constexpr std::array<std::string_view, 4> directions{"ahead", "right", "behind",
                                                     "left"};  // clockwise from the heading
constexpr std::array<std::string_view, 3> events{"moved", "turned_left", "turned_right"};

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

// Inserts propositions by name; a name the vocabulary lacks is an error.
class Writer {
 public:
  Writer(const ltl::Vocabulary& vocabulary, ltl::Letter& letter) : vocabulary_(vocabulary), letter_(letter) {}
  void add(std::string_view prefix, std::string_view what) {
    const std::string name = std::string(prefix) + std::string(what);
    const auto p = vocabulary_.find(name);
    if (!p) throw std::invalid_argument("the map shows '" + std::string(what) + "', which it does not list");
    letter_.insert(*p);
  }

 private:
  const ltl::Vocabulary& vocabulary_;
  ltl::Letter& letter_;
};

void write_here(const Hallways& hallways, std::uint32_t node, Writer& writer) {
  const Node& here = hallways.nodes()[node];
  if (here.object) writer.add("", *here.object);
  if (here.place) writer.add("place_", std::to_string(*here.place));
  for (std::string_view kind : kinds_of(hallways, node)) writer.add("", kind);
  for (int heading = 0; heading < 360; heading += 90) {
    const Edge* way = hallways.hallway(node, heading);
    if (way != nullptr && !way->floor.empty()) writer.add("", way->floor);
  }
}

// `sight`: the objects along the hallway that way, by their bare propositions.
void write_seen(const Hallways& hallways, std::uint32_t node, int heading, std::string_view direction,
                const ltl::Letter& sight, const ltl::Vocabulary& vocabulary, Writer& writer) {
  const std::string prefix = std::string(direction) + "_";
  const Edge* way = hallways.hallway(node, heading);
  writer.add(prefix, way == nullptr ? "wall" : "open");
  if (way == nullptr) return;
  if (!way->floor.empty()) writer.add(prefix, way->floor);
  if (!way->wall.empty()) writer.add(prefix, way->wall);
  for (ltl::Proposition object : sight.members()) writer.add(prefix, vocabulary.name(object));
}

void write_next(const Hallways& hallways, std::uint32_t node, int heading, Writer& writer) {
  const auto next = hallways.neighbour(node, heading);
  if (!next) return;
  if (hallways.nodes()[*next].object) writer.add("next_", *hallways.nodes()[*next].object);
  for (std::string_view kind : kinds_of(hallways, *next)) writer.add("next_", kind);
}

}  // namespace

ltl::Vocabulary hallway_vocabulary(const Observables& observables) {
  ltl::Vocabulary vocabulary;
  const auto add = [&](std::string_view prefix, std::string_view what) {
    const std::string name = std::string(prefix) + std::string(what);
    if (what.empty()) throw std::invalid_argument("an observable needs a name");
    if (vocabulary.find(name))
      throw std::invalid_argument("two observables would share the proposition '" + name + "'");
    vocabulary.add(name);
  };
  const auto add_all = [&](std::string_view prefix, const auto& names) {
    for (const auto& name : names) add(prefix, name);
  };
  add_all("", events);
  add_all("", observables.objects);
  add_all("", observables.floors);
  add_all("", kinds);
  for (std::string_view direction : directions) {
    const std::string prefix = std::string(direction) + "_";
    add_all(prefix, observables.objects);
    add_all(prefix, observables.floors);
    add_all(prefix, observables.walls);
    add_all(prefix, std::array<std::string_view, 2>{"wall", "open"});
  }
  add_all("next_", observables.objects);
  add_all("next_", kinds);
  for (int place = 1; place <= observables.places; ++place) add("place_", std::to_string(place));
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
