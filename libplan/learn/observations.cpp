#include "libplan/learn/observations.hpp"

#include <algorithm>
#include <optional>

namespace waymark::plan {
namespace {

using Distances = std::vector<std::optional<std::uint32_t>>;

// Breadth first, backwards: expand(i, meet) calls meet(j) for everything one step before i.
template <class Expand>
Distances backwards(Distances distance, Expand&& expand) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t i = 0; i < distance.size(); ++i)
    if (distance[i]) queue.push_back(i);
  for (std::size_t head = 0; head < queue.size(); ++head)
    expand(queue[head], [&](std::uint32_t before) {
      if (distance[before]) return;
      distance[before] = *distance[queue[head]] + 1;
      queue.push_back(before);
    });
  return distance;
}

std::vector<std::string> named(const Map& map, Sight sight) {
  std::vector<std::string> names = map.objects();
  if (sight != Sight::Landmarks) return names;
  names.insert(names.end(), map.floors().begin(), map.floors().end());
  for (const std::string& wall : map.walls()) names.push_back("ahead_" + wall);
  return names;
}

}  // namespace

Distances actions_to(const Map& map, ltl::Proposition p) {
  Distances start(map.poses());
  for (std::uint32_t i = 0; i < map.poses(); ++i)
    if (map.label(PoseId{i}).contains(p)) start[i] = 0;
  return backwards(std::move(start), [&](std::uint32_t i, auto&& meet) {
    for (const Action action : all_actions)
      if (const auto before = map.predecessor(PoseId{i}, action)) meet(before->index);
  });
}

Distances segments_to(const Map& map, ltl::Proposition p) {
  Distances start(map.nodes().size());
  for (std::uint32_t node = 0; node < start.size(); ++node)
    if (map.label(PoseId{4 * node}).contains(p)) start[node] = 0;
  const Distances by_node = backwards(std::move(start), [&](std::uint32_t node, auto&& meet) {
    for (const int heading : {0, 90, 180, 270})
      if (const auto next = map.neighbour(node, heading)) meet(*next);
  });
  Distances by_pose;
  for (std::uint32_t i = 0; i < map.poses(); ++i) by_pose.push_back(by_node[i / 4]);
  return by_pose;
}

Observations observe(const Map& map, Sight sight) {
  Observations seen{named(map, sight), {}};
  std::vector<Distances> rows;
  std::uint32_t greatest = 1;
  for (const std::string& name : seen.names) {
    const ltl::Proposition p = map.vocabulary().find(name).value();
    rows.push_back(sight == Sight::Literal ? segments_to(map, p) : actions_to(map, p));
    for (const auto& distance : rows.back()) greatest = std::max(greatest, distance.value_or(0));
  }
  seen.by_position.resize(static_cast<neural::Index>(rows.size()), static_cast<neural::Index>(map.poses()));
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t pose = 0; pose < map.poses(); ++pose)
      seen.by_position(static_cast<neural::Index>(row), static_cast<neural::Index>(pose)) =
          static_cast<float>(rows[row][pose].value_or(greatest)) / static_cast<float>(greatest);
  return seen;
}

}  // namespace waymark::plan
