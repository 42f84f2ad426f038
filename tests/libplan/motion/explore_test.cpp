#include "libplan/motion/explore.hpp"

#include <gtest/gtest.h>

#include "libautomata/ltlf_to_dfa.hpp"
#include "libltl/parse.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

// Certified when there is a motion.
Explored explored(const std::string& formula, const Workspace& workspace, PoseId start, const Robot& robot) {
  ltl::Arena arena(workspace.map().vocabulary());
  const ltl::Formula phi = ltl::parse(formula, arena);
  Explored outcome = explore(automata::ltlf_to_dfa(phi), workspace, start, {.seconds = 20, .robot = robot});
  const auto* motion = std::get_if<Motion>(&outcome);
  if (motion != nullptr) certify(*motion, workspace, phi);
  return outcome;
}

TEST(Explore, FindsMotionsOfDiscsAndCars) {
  const Map map = square();
  const Workspace workspace(map);
  for (const Robot& robot : {Robot(Disc{}), Robot(Disc{0}), Robot(Car{})})
    for (const char* formula :
         {"F sofa", "X(moved & X(turned_right & X(sofa & moved)))", "F(sofa & F place_1)"})
      EXPECT_TRUE(std::holds_alternative<Motion>(explored(formula, workspace, pose_at(map, 0, 0, 90), robot)))
          << formula << " " << robot.index();
}

TEST(Explore, AnUnsolvableTaskIsNoRunAndNoCrash) {
  const Map map = square();
  const Workspace workspace(map);
  for (const char* formula : {"F chair", "F sofa & G !sofa", "X(moved & X(moved))", "!place_1", "false"})
    EXPECT_TRUE(std::holds_alternative<NoRun>(explored(formula, workspace, pose_at(map, 0, 0, 90), Disc{})))
        << formula;
}

TEST(Explore, ReadsTheLetterOfTheStart) {
  const Map map = square();
  const Workspace workspace(map);
  const auto outcome = explored("place_1", workspace, pose_at(map, 0, 0, 90), Disc{});
  ASSERT_TRUE(std::holds_alternative<Motion>(outcome));
  EXPECT_EQ(std::get<Motion>(outcome).configurations.size(), 1U);
}

}  // namespace
}  // namespace waymark::plan
