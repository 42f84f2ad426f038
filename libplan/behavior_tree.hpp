// A plan as a behaviour tree for robots: the XML of BehaviorTree.CPP, version 4; for such trees see [CO18].
//
// A sequence has one action node for each action of the plan, with the poses before and behind it as ports. The last
// actions, where they are repeated for ever, stand in a sequence under Repeat. Whether a plan is certified is up to the
// caller: the tree does what the trajectory says.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "libplan/world/map.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::plan {

// The nodes are Forward, Left and Right with the ports `from` and `to`, poses as (x,y,heading). `task`: the name of the
// sequence. A plan without actions succeeds at once.
std::string write_behavior_tree(const Trajectory& plan, const Map& map, std::string_view task,
                                std::size_t repeated_actions = 0);

}  // namespace waymark::plan
