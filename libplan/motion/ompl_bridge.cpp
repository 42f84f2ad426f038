#include "libplan/motion/ompl_bridge.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/RejectionInfSampler.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/util/Console.h>

#include <memory>

namespace waymark::plan {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using State = ob::RealVectorStateSpace::StateType;

Point point_of(const ob::State* state) {
  const auto& values = *state->as<State>();
  return {values[0], values[1]};
}

class SeededSampler : public ob::RealVectorStateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint32_t seed) : RealVectorStateSampler(space) {
    rng_.setLocalSeed(seed);
  }
};

class Plane : public ob::RealVectorStateSpace {
 public:
  explicit Plane(std::uint32_t seed) : RealVectorStateSpace(2), seed_(seed) {}
  ob::StateSamplerPtr allocDefaultStateSampler()
      const override {  // sampling by rejection asks for the default
    return std::make_shared<SeededSampler>(this, seed_);
  }

 private:
  std::uint32_t seed_;
};

class SeededPlanner : public og::InformedRRTstar {
 public:
  SeededPlanner(const ob::SpaceInformationPtr& space, std::uint32_t seed) : InformedRRTstar(space) {
    rng_.setLocalSeed(seed);
    setPrunedMeasure(false);  // sampling by rejection does not know the measure of the subset
  }
};

class PathLength : public ob::PathLengthOptimizationObjective {
 public:
  using PathLengthOptimizationObjective::PathLengthOptimizationObjective;
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                   unsigned int attempts) const override {
    return std::make_shared<ob::RejectionInfSampler>(problem, attempts);
  }
};

class Validator : public ob::MotionValidator {  // exact along the whole segment, not state by state
 public:
  Validator(const ob::SpaceInformationPtr& space, std::function<bool(Point, Point)> is_free)
      : MotionValidator(space), is_free_(std::move(is_free)) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return is_free_(point_of(a), point_of(b));
  }
  // Planners that keep the part of a motion before the obstacle ask this; none of ours does.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    const bool free = checkMotion(a, b);
    if (!free && last_valid.first != nullptr) si_->copyState(last_valid.first, a);
    if (!free) last_valid.second = 0;
    return free;
  }

 private:
  std::function<bool(Point, Point)> is_free_;
};

ob::SpaceInformationPtr make_space(const SamplingProblem& problem, std::uint32_t seed) {
  const auto plane = std::make_shared<Plane>(seed);
  ob::RealVectorBounds bounds(2);
  bounds.low = {problem.low.x, problem.low.y};
  bounds.high = {problem.high.x, problem.high.y};
  plane->setBounds(bounds);
  auto space = std::make_shared<ob::SpaceInformation>(plane);
  space->setStateValidityChecker([is_free = problem.is_free](const ob::State* state) {
    return is_free(point_of(state), point_of(state));
  });
  space->setMotionValidator(std::make_shared<Validator>(space, problem.is_free));
  space->setup();
  return space;
}

ob::ProblemDefinitionPtr make_definition(const SamplingProblem& problem,
                                         const ob::SpaceInformationPtr& space) {
  const auto state_at = [&](Point p) {
    ob::ScopedState<ob::RealVectorStateSpace> state(space);
    state[0] = p.x;
    state[1] = p.y;
    return state;
  };
  auto definition = std::make_shared<ob::ProblemDefinition>(space);
  definition->addStartState(state_at(problem.start));
  const auto goals = std::make_shared<ob::GoalStates>(space);
  for (Point goal : problem.goals) goals->addState(state_at(goal));
  definition->setGoal(goals);
  definition->setOptimizationObjective(std::make_shared<PathLength>(space));
  return definition;
}

}  // namespace

std::vector<Point> sample_path(const SamplingProblem& problem, std::size_t iterations, std::uint32_t seed) {
  ompl::msg::noOutputHandler();
  const ob::SpaceInformationPtr space = make_space(problem, seed);
  const ob::ProblemDefinitionPtr definition = make_definition(problem, space);
  SeededPlanner planner(space, seed);
  planner.setProblemDefinition(definition);
  planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();  // OMPL's default draws random pivots
  ob::IterationTerminationCondition budget(static_cast<unsigned int>(iterations));
  planner.solve(budget);
  std::vector<Point> points;
  if (!definition->hasExactSolution()) return points;
  for (const ob::State* state : definition->getSolutionPath()->as<og::PathGeometric>()->getStates())
    points.push_back(point_of(state));
  return points;
}

}  // namespace waymark::plan
