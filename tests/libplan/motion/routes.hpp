// What the tests of motions share: routes, at random and by their actions, and that a motion reads back as its route.
#pragma once
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "libplan/motion/workspace.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {

inline Trajectory route(const std::string& text, const Map& map) { return parse_trajectory(text, map); }

inline std::string show_line(const Motion& motion) {
  std::string out;
  for (const Configuration& c : motion.configurations)
    out += "{" + std::to_string(c.x) + ", " + std::to_string(c.y) + ", " + std::to_string(c.heading) + "} ";
  return out;
}

// The motion's own route is the one that it was made from.
inline void expect_read_back(const Motion& motion, const Trajectory& route, const Workspace& workspace,
                             const std::string& label) {
  const auto read = route_of(motion, workspace);
  if (const auto* fault = std::get_if<NoRoute>(&read))
    ADD_FAILURE() << label << " at " << fault->step << ": " << fault->reason << "\n" << show_line(motion);
  else
    EXPECT_EQ(std::get<Trajectory>(read), route) << label << "\n" << show_line(motion);
}

inline Trajectory random_route(const Map& map, std::size_t actions, std::mt19937_64& random) {
  Trajectory out{{PoseId{static_cast<std::uint32_t>(random() % map.poses())}}, {}};
  while (out.actions.size() < actions) {
    const std::size_t pick = random() % 5;  // FORWARD more often: longer legs
    const Action action = pick < 3 ? Action::Forward : all_actions[pick - 2];
    const auto next = map.successor(out.poses.back(), action);
    if (!next) continue;
    out.poses.push_back(*next);
    out.actions.push_back(action);
  }
  return out;
}

// A hallway of two segments with a sofa half way.
inline Map past_a_sofa() {
  return Map("past a sofa", {{0, 0, {}, {}}, {1, 0, "sofa", {}}, {2, 0, {}, {}}}, {{0, 1, "", ""}, {1, 2, "", ""}},
             {"sofa"}, {}, {});
}

}  // namespace waymark::plan
