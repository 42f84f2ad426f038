#include "libplan/model/map_mdp.hpp"

#include <array>
#include <stdexcept>

namespace waymark::plan {
namespace {

constexpr std::array<int, 4> by_turn{0, 90, 180, 270};  // forward, right, back, left

// The pose that FORWARD ends in when it goes off by so many degrees.
PoseId moved(const Map& map, PoseId from, int turn) {
  const Pose pose = map.pose(from);
  const auto node = map.neighbour(map.node_of(from), (pose.heading + turn) % 360);
  return node ? PoseId{4 * *node + from.index % 4} : from;
}

void add_forward(MdpBuilder& builder, const Map& map, PoseId from, const SlipChances& slip) {
  const std::array<double, 4> chance{slip.forward, slip.right, slip.back, slip.left};
  builder.add_choice(name(Action::Forward), map.cost(Action::Forward));
  for (std::size_t i = 0; i < 4; ++i) {
    if (chance[i] == 0) continue;
    const PoseId to = moved(map, from, by_turn[i]);
    builder.add_outcome(to.index, builder.letter(map.letter(to, Action::Forward)), chance[i]);
  }
}

}  // namespace

Mdp mdp_of(const Map& map, PoseId start, const SlipChances& forward) {
  MdpBuilder builder(map.vocabulary());
  for (std::uint32_t i = 0; i < map.poses(); ++i) {
    const PoseId from{i};
    builder.add_state(show(map.pose(from)));
    for (Action action : all_actions) {
      const auto to = map.successor(from, action);
      if (!to) continue;
      if (action == Action::Forward) {
        add_forward(builder, map, from, forward);
        continue;
      }
      builder.add_choice(name(action), map.cost(action));
      builder.add_outcome(to->index, builder.letter(map.letter(*to, action)));
    }
  }
  const LetterId first = builder.letter(map.label(start));
  return std::move(builder).build(start.index, first);
}

}  // namespace waymark::plan
