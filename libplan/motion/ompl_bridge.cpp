#include "libplan/motion/ompl_bridge.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/RejectionInfSampler.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace waymark::plan {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using CarState = ob::SE2StateSpace::StateType;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double longest_arc = 45;

Point point_of(const ob::State* state) {
  const auto& values = *state->as<ob::RealVectorStateSpace::StateType>();
  return {values[0], values[1]};
}

// OMPL's yaw runs from the x-axis towards the y-axis, which with y southwards is clockwise, as headings are.
Configuration configuration_of(const ob::State* state) {
  const auto& pose = *state->as<CarState>();
  return {pose.getX(), pose.getY(), normalized(pose.getYaw() / degree + quarter_turn)};
}

void set(ob::State* state, Point p) {
  auto& values = *state->as<ob::RealVectorStateSpace::StateType>();
  values[0] = p.x;
  values[1] = p.y;
}

void set(ob::State* state, const Configuration& c) {
  auto& pose = *state->as<CarState>();
  pose.setXY(c.x, c.y);
  pose.setYaw(-turn_between(c.heading, quarter_turn) * degree);  // −π ≤ yaw < π, or no start is taken
}

// The space of a car, of which the problem says what part is sampled.
class CarSpace : public ob::ReedsSheppStateSpace {
 public:
  explicit CarSpace(const DriveProblem& problem) : ReedsSheppStateSpace(problem.turning_radius), problem_(problem) {}
  ob::StateSamplerPtr allocDefaultStateSampler() const override;
  const DriveProblem& problem() const { return problem_; }

 private:
  const DriveProblem& problem_;
};

class CarSampler : public ob::StateSampler {
 public:
  explicit CarSampler(const CarSpace* space) : StateSampler(space), problem_(space->problem()) {}
  void sampleUniform(ob::State* state) override {
    const double x = rng_.uniformReal(problem_.low.x, problem_.high.x);
    const double y = rng_.uniformReal(problem_.low.y, problem_.high.y);
    const double aside = rng_.uniformReal(-problem_.aside, problem_.aside);
    set(state, Configuration{x, y, normalized(problem_.heading + aside)});
  }
  // Planners that look around a state ask for these; none of ours does.
  void sampleUniformNear(ob::State* state, const ob::State*, double) override { sampleUniform(state); }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  const DriveProblem& problem_;
};

ob::StateSamplerPtr CarSpace::allocDefaultStateSampler() const { return std::make_shared<CarSampler>(this); }

class PathLength : public ob::PathLengthOptimizationObjective {
 public:
  using PathLengthOptimizationObjective::PathLengthOptimizationObjective;
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                   unsigned int attempts) const override {
    return std::make_shared<ob::RejectionInfSampler>(problem, attempts);
  }
};

using IsFree = std::function<bool(const ob::State*, const ob::State*)>;

class Validator : public ob::MotionValidator {  // proved along the whole motion, not state by state
 public:
  Validator(const ob::SpaceInformationPtr& space, IsFree is_free)
      : MotionValidator(space), is_free_(std::move(is_free)) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override { return is_free_(a, b); }
  // Planners that keep the part of a motion before the obstacle ask this; none of ours does.
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last_valid) const override {
    const bool free = checkMotion(a, b);
    if (!free && last_valid.first != nullptr) si_->copyState(last_valid.first, a);
    if (!free) last_valid.second = 0;
    return free;
  }

 private:
  IsFree is_free_;
};

class RrtStar : public og::InformedRRTstar {
 public:
  explicit RrtStar(const ob::SpaceInformationPtr& space) : InformedRRTstar(space) {
    setPrunedMeasure(false);  // sampling by rejection does not know the measure of the subset
  }
};

ob::PlannerPtr planner_for(Sampler sampler, const ob::SpaceInformationPtr& space) {
  if (sampler == Sampler::BitStar) return std::make_shared<og::BITstar>(space);
  return std::make_shared<RrtStar>(space);
}

ob::RealVectorBounds bounds(Point low, Point high) {
  ob::RealVectorBounds out(2);
  out.low = {low.x, low.y};
  out.high = {high.x, high.y};
  return out;
}

// The states of the path that the sampler found, read by `read`; empty when there is none.
template <typename Value, typename Read>
std::vector<Value> search(const ob::StateSpacePtr& states, const IsFree& is_free, const Value& start,
                          const std::vector<Value>& goals, const SamplingBudget& budget, Read read) {
  const auto space = std::make_shared<ob::SpaceInformation>(states);
  space->setStateValidityChecker([&](const ob::State* state) { return is_free(state, state); });
  space->setMotionValidator(std::make_shared<Validator>(space, is_free));
  space->setup();
  const auto definition = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<> state(space);
  set(state.get(), start);
  definition->addStartState(state);
  const auto goal = std::make_shared<ob::GoalStates>(space);
  for (const Value& value : goals) {
    set(state.get(), value);
    goal->addState(state);
  }
  definition->setGoal(goal);
  definition->setOptimizationObjective(std::make_shared<PathLength>(space));
  const ob::PlannerPtr planner = planner_for(budget.sampler, space);
  planner->setProblemDefinition(definition);
  ob::IterationTerminationCondition stop(static_cast<unsigned int>(budget.iterations));
  planner->solve(stop);
  std::vector<Value> found;
  if (!definition->hasExactSolution()) return found;
  for (const ob::State* on_path : definition->getSolutionPath()->as<og::PathGeometric>()->getStates())
    found.push_back(read(on_path));
  return found;
}

void begin_random_numbers(std::uint32_t seed) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(std::max(seed, 1U));  // 0 is not taken
}

Line driven(const ob::ReedsSheppStateSpace& space, const ob::State* a, const ob::State* b, double turning_radius) {
  const ob::ReedsSheppStateSpace::ReedsSheppPath path = space.reedsShepp(a, b);
  Line line{configuration_of(a)};
  for (std::size_t i = 0; i < 5; ++i) {
    const double part = path.length_[i];  // in turning radii, negative backwards
    if (path.type_[i] == ob::ReedsSheppStateSpace::RS_NOP || std::abs(part) < 1e-9) continue;
    const double turn = path.type_[i] == ob::ReedsSheppStateSpace::RS_STRAIGHT ? 0
                        : path.type_[i] == ob::ReedsSheppStateSpace::RS_LEFT   ? part / degree
                                                                               : -part / degree;
    const auto arcs = static_cast<int>(std::max(1.0, std::ceil(std::abs(turn) / longest_arc)));
    const Piece whole = Piece::driving(line.back(), part * turning_radius, turn);
    for (int k = 1; k <= arcs; ++k) line.push_back(whole.at(1.0 * k / arcs));
  }
  if (line.size() > 1) line.back() = configuration_of(b);
  return line;
}

}  // namespace

std::vector<Point> sample_path(const PathProblem& problem, const SamplingBudget& budget) {
  begin_random_numbers(budget.seed);
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  plane->setBounds(bounds(problem.low, problem.high));
  const IsFree is_free = [&](const ob::State* a, const ob::State* b) {
    return problem.is_free(point_of(a), point_of(b));
  };
  return search(plane, is_free, problem.start, problem.goals, budget, point_of);
}

Line shortest_drive(const Configuration& from, const Configuration& to, double turning_radius) {
  ompl::msg::noOutputHandler();
  const auto space = std::make_shared<ob::ReedsSheppStateSpace>(turning_radius);
  ob::ScopedState<> a(space), b(space);
  set(a.get(), from);
  set(b.get(), to);
  Line line = driven(*space, a.get(), b.get(), turning_radius);
  line.front() = from;  // headings as they were given, not as radians bring them back
  if (line.size() > 1) line.back() = to;
  return line;
}

Line sample_drive(const DriveProblem& problem, const SamplingBudget& budget) {
  begin_random_numbers(budget.seed);
  const auto space = std::make_shared<CarSpace>(problem);
  space->setBounds(bounds(problem.low, problem.high));
  const IsFree is_free = [&](const ob::State* a, const ob::State* b) {
    return problem.is_free(driven(*space, a, b, problem.turning_radius));
  };
  const std::vector<Configuration> corners =
      search(space, is_free, problem.start, problem.goals, budget, configuration_of);
  Line line;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i == 0) {
      line.push_back(problem.start);
      continue;
    }
    const Line part = shortest_drive(line.back(), corners[i], problem.turning_radius);
    line.insert(line.end(), part.begin() + 1, part.end());
  }
  return line;
}

}  // namespace waymark::plan
