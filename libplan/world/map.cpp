#include "libplan/world/map.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace waymark::plan {
namespace {

Hallways assemble(const std::vector<Node>& nodes, const std::vector<Edge>& edges) {
  Hallways hallways;
  for (const Node& node : nodes) hallways.add_node(node);
  for (const Edge& edge : edges) hallways.add_edge(edge);
  return hallways;
}

int highest_place(const Hallways& hallways) {
  int highest = 0;
  for (const Node& node : hallways.nodes()) highest = std::max(highest, node.place.value_or(0));
  return highest;
}

struct LetterHash {
  std::size_t blocks;  // of the vocabulary
  std::size_t operator()(const ltl::Letter& letter) const {
    std::size_t hash = 0;
    for (std::size_t i = 0; i < blocks; ++i) {
      hash = (hash ^ letter.block(i)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace

std::string_view name(Action action) {
  switch (action) {
    case Action::Forward: return "FORWARD";
    case Action::Left: return "LEFT";
    case Action::Right: return "RIGHT";
  }
  throw std::logic_error("not an action");
}

Map::Map(std::string name, Hallways hallways, std::vector<std::string> objects, std::vector<std::string> floors,
         std::vector<std::string> walls)
    : name_(std::move(name)),
      hallways_(std::move(hallways)),
      observables_{std::move(objects), std::move(floors), std::move(walls), highest_place(hallways_)},
      letters_(hallway_vocabulary(observables_)) {
  if (nodes().empty()) throw std::invalid_argument("a map needs at least one node");
  if (nodes().size() > max_size / vocabulary().size())
    throw std::invalid_argument("the map is too large: " + std::to_string(nodes().size()) + " nodes, " +
                                std::to_string(vocabulary().size()) + " propositions");
  tabulate_letters();
  tabulate_successors();
}

Map::Map(std::string name, const std::vector<Node>& nodes, const std::vector<Edge>& edges,
         std::vector<std::string> objects, std::vector<std::string> floors, std::vector<std::string> walls)
    : Map(std::move(name), assemble(nodes, edges), std::move(objects), std::move(floors), std::move(walls)) {}

void Map::tabulate_letters() {
  std::unordered_map<ltl::Letter, LetterId, LetterHash> ids(64, LetterHash{vocabulary().size() / 64 + 1});
  const auto intern = [&](const ltl::Letter& letter) {
    const auto [it, is_new] = ids.try_emplace(letter, LetterId{static_cast<std::uint32_t>(letters_.size())});
    if (is_new) letters_.intern(letter);
    return it->second;
  };
  const std::array<ltl::Proposition, 3> events{*vocabulary().find("moved"), *vocabulary().find("turned_left"),
                                               *vocabulary().find("turned_right")};
  const Labelling labelling(hallways_, vocabulary());
  letter_ids_.resize(poses());
  for (std::uint32_t p = 0; p < poses(); ++p) {
    const ltl::Letter label = labelling.label(p / 4, static_cast<int>(p % 4) * 90);
    letter_ids_[p][3] = intern(label);
    for (std::size_t a = 0; a < all_actions.size(); ++a) {
      ltl::Letter after = label;
      after.insert(events[a]);
      letter_ids_[p][a] = intern(after);
    }
  }
}

void Map::tabulate_successors() {
  successors_.resize(poses());
  for (std::uint32_t p = 0; p < poses(); ++p) {
    const std::uint32_t node = p / 4, quarter = p % 4;
    const auto next = hallways_.neighbour(node, static_cast<int>(quarter) * 90);
    successors_[p] = {next ? 4 * *next + quarter : wall_ahead, 4 * node + (quarter + 3) % 4,
                      4 * node + (quarter + 1) % 4};
  }
}

Pose Map::pose(PoseId p) const {
  const Node& node = nodes().at(p.index / 4);
  return {node.x, node.y, static_cast<int>(p.index % 4) * 90};
}

std::optional<PoseId> Map::predecessor(PoseId p, Action action) const {
  const std::uint32_t node = p.index / 4, quarter = p.index % 4;
  switch (action) {
    case Action::Left: return successor(p, Action::Right);
    case Action::Right: return successor(p, Action::Left);
    case Action::Forward: break;
  }
  const auto behind = hallways_.neighbour(node, static_cast<int>((quarter + 2) % 4) * 90);
  if (!behind) return std::nullopt;
  return PoseId{4 * *behind + quarter};
}

std::optional<PoseId> Map::find(const Pose& pose) const {
  if (pose.heading < 0 || pose.heading >= 360 || pose.heading % 90 != 0) return std::nullopt;
  const auto node = hallways_.node_at(pose.x, pose.y);
  if (!node) return std::nullopt;
  return PoseId{4 * *node + static_cast<std::uint32_t>(pose.heading) / 90};
}

}  // namespace waymark::plan
