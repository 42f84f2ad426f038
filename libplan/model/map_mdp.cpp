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

void add_turn(MdpBuilder& builder, const Map& map, PoseId from, Action action, const TurnChances& chance) {
  const PoseId once = *map.successor(from, action), twice = *map.successor(once, action);
  builder.add_choice(name(action), map.cost(action));
  const auto add = [&](PoseId to, double probability) {
    if (probability > 0) builder.add_outcome(to.index, builder.letter(map.letter(to, action)), probability);
  };
  add(once, 1 - chance.stay - chance.beyond);
  add(from, chance.stay);
  add(twice, chance.beyond);
}

}  // namespace

Mdp mdp_of(const Map& map, PoseId start, const MapNoise& noise) {
  const TurnChances& turn = noise.turn;
  if (!(turn.stay >= 0 && turn.beyond >= 0 && turn.stay + turn.beyond < 1))
    throw std::invalid_argument("the chances of a turn leave nothing for turning");
  MdpBuilder builder(map.vocabulary());
  for (std::uint32_t i = 0; i < map.poses(); ++i) {
    const PoseId from{i};
    builder.add_state(show(map.pose(from)));
    for (Action action : all_actions) {
      if (action != Action::Forward)
        add_turn(builder, map, from, action, turn);
      else if (map.successor(from, action))
        add_forward(builder, map, from, noise.forward);
    }
  }
  const LetterId first = builder.letter(map.label(start));
  return std::move(builder).build(start.index, first);
}

}  // namespace waymark::plan
