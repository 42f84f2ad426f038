#include "libplan/world/labelling.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace waymark::plan {
namespace {

using namespace std::string_literals;

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

void write_seen(const Hallways& hallways, std::uint32_t node, int heading, std::string_view direction,
                Writer& writer) {
  const std::string prefix = std::string(direction) + "_";
  const Edge* way = hallways.hallway(node, heading);
  writer.add(prefix, way == nullptr ? "wall" : "open");
  if (way == nullptr) return;
  if (!way->floor.empty()) writer.add(prefix, way->floor);
  if (!way->wall.empty()) writer.add(prefix, way->wall);
  for (auto at = hallways.neighbour(node, heading); at; at = hallways.neighbour(*at, heading))
    if (hallways.nodes()[*at].object) writer.add(prefix, *hallways.nodes()[*at].object);
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

ltl::Letter hallway_label(const Hallways& hallways, const ltl::Vocabulary& vocabulary, std::uint32_t node,
                          int heading) {
  ltl::Letter letter;
  Writer writer(vocabulary, letter);
  write_here(hallways, node, writer);
  for (std::size_t i = 0; i < directions.size(); ++i)
    write_seen(hallways, node, (heading + 90 * static_cast<int>(i)) % 360, directions[i], writer);
  write_next(hallways, node, heading, writer);
  return letter;
}

}  // namespace waymark::plan
