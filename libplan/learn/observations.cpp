#include "libplan/learn/observations.hpp"

#include <algorithm>
#include <optional>

#include "libplan/world/observable.hpp"

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
  for (const std::string& wall : map.walls())
    names.push_back(proposition_name({Direction::Ahead, Kind::Painting, wall}));
  return names;
}

// Rows divided by the greatest distance of all.
Observations scaled(std::vector<std::string> names, const std::vector<Distances>& rows, std::size_t positions) {
  std::uint32_t greatest = 1;
  for (const Distances& row : rows)
    for (const auto& distance : row) greatest = std::max(greatest, distance.value_or(0));
  Observations seen{std::move(names), {}};
  seen.by_position.resize(static_cast<neural::Index>(rows.size()), static_cast<neural::Index>(positions));
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t at = 0; at < positions; ++at)
      seen.by_position(static_cast<neural::Index>(row), static_cast<neural::Index>(at)) =
          static_cast<float>(rows[row][at].value_or(greatest)) / static_cast<float>(greatest);
  return seen;
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
  std::vector<std::string> names = named(map, sight);
  std::vector<Distances> rows;
  for (const std::string& name : names) {
    const ltl::Proposition p = map.vocabulary().find(name).value();
    rows.push_back(sight == Sight::Literal ? segments_to(map, p) : actions_to(map, p));
  }
  return scaled(std::move(names), rows, map.poses());
}

template <class Model>
Observations observe(const Model& model) {
  const auto states = static_cast<std::uint32_t>(model.states());
  std::vector<std::string> names;
  std::vector<Distances> rows;
  for (std::uint32_t i = 0; i < model.letters().vocabulary().size(); ++i) {
    const ltl::Proposition p{i};
    Distances shown(states);
    if (model.letters()[model.initial_letter()].contains(p)) shown[model.initial()] = 0;
    for (std::uint32_t s = 0; s < states; ++s)
      for (std::uint32_t k = 0; k < model.choices(s); ++k)
        model.for_each_outcome(s, k, [&](std::uint32_t target, LetterId letter, double) {
          if (model.letters()[letter].contains(p)) shown[target] = 0;
        });
    if (std::none_of(shown.begin(), shown.end(), [](const auto& d) { return d.has_value(); })) continue;
    names.push_back(model.letters().vocabulary().name(p));
    rows.push_back(backwards(std::move(shown), [&](std::uint32_t s, auto&& meet) {
      model.for_each_predecessor(s, [&](std::uint32_t before) { meet(before); });
    }));
  }
  return scaled(std::move(names), rows, states);
}

template Observations observe(const Mdp&);
template Observations observe(const GridWorld&);

}  // namespace waymark::plan
