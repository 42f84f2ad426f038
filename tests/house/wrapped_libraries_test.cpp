// The libraries that we wrap in cmake/ because their packages export no targets: the wrapper is enough to use them.
#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

namespace waymark::house {
namespace {

TEST(WrappedLibraries, OmplFindsAWayAroundAWall) {
  ompl::msg::noOutputHandler();
  auto plane = std::make_shared<ompl::base::RealVectorStateSpace>(2);
  plane->setBounds(0, 1);
  ompl::geometric::SimpleSetup setup(plane);
  setup.setStateValidityChecker([](const ompl::base::State* state) {  // a wall at x = ½, open above y = 0.8
    const auto& point = *state->as<ompl::base::RealVectorStateSpace::StateType>();
    return point[0] < 0.45 || point[0] > 0.55 || point[1] > 0.8;
  });
  ompl::base::ScopedState<ompl::base::RealVectorStateSpace> start(plane), goal(plane);
  start[0] = start[1] = goal[1] = 0.1;
  goal[0] = 0.9;
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
  ASSERT_EQ(setup.solve(10.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(setup.getSolutionPath().check());
}

}  // namespace
}  // namespace waymark::house
