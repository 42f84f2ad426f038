#include "libplan/motion/ltl_bridge.hpp"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/control/StatePropagator.h>
#include <ompl/control/planners/ltl/Automaton.h>
#include <ompl/control/planners/ltl/LTLPlanner.h>
#include <ompl/control/planners/ltl/LTLProblemDefinition.h>
#include <ompl/control/planners/ltl/LTLSpaceInformation.h>
#include <ompl/control/planners/ltl/ProductGraph.h>
#include <ompl/control/planners/ltl/PropositionalDecomposition.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

namespace waymark::plan {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;
using State = ob::SE2StateSpace::StateType;
using Control = oc::RealVectorControlSpace::ControlType;

constexpr double quarter_turn = 90, degree = 3.14159265358979323846 / 180;
constexpr double turn_step = 15;  // degrees that a disc turns in one step, at most
constexpr unsigned int most_steps = 12;
constexpr double explore_seconds = 0.02;  // along one lead, before another one is computed

Configuration configuration_of(const ob::State* state) {
  const auto& pose = *state->as<State>();
  return {pose.getX(), pose.getY(), normalized(pose.getYaw() / degree + quarter_turn)};
}

void set(ob::State* state, const Configuration& c) {
  auto& pose = *state->as<State>();
  pose.setXY(c.x, c.y);
  pose.setYaw(turn_between(quarter_turn, c.heading) * degree);
}

// One step. Controls run from −1 to 1: the speed (a disc only goes ahead), and the steering: the curvature of a car, the
// rate at which a disc turns.
Configuration stepped(const ExplorationProblem& problem, const Configuration& from, double speed,
                      double steering) {
  if (const auto* car = std::get_if<Car>(&problem.robot)) {
    const double way = problem.step * speed;
    return Piece::driving(from, way, way * steering / car->turning_radius / degree).at(1);
  }
  const double turn = turn_step * steering, way = problem.step * (speed + 1) / 2;
  const Point towards = ahead_of(from.heading + turn / 2);
  return {from.x + way * towards.x, from.y + way * towards.y, normalized(from.heading + turn)};
}

class Cells : public oc::Decomposition {
 public:
  Cells(const ExplorationProblem& problem, const ob::RealVectorBounds& bounds)
      : Decomposition(2, bounds), problem_(problem) {}
  int getNumRegions() const override { return static_cast<int>(problem_.regions.size()); }
  double getRegionVolume(int region) override { return at(region).volume; }
  int locateRegion(const ob::State* state) const override {
    if (std::isnan(state->as<State>()->getX())) return -1;
    const auto region = problem_.region_of(configuration_of(state));
    return region ? static_cast<int>(*region) : -1;
  }
  void project(const ob::State* state, std::vector<double>& out) const override {
    out = {state->as<State>()->getX(), state->as<State>()->getY()};
  }
  void getNeighbors(int region, std::vector<int>& out) const override { out = at(region).neighbours; }
  // Planners that sample regions ask for these; LTLPlanner does not.
  void sampleFromRegion(int, ompl::RNG&, std::vector<double>&) const override {}
  void sampleFullState(const ob::StateSamplerPtr&, const std::vector<double>&, ob::State*) const override {}
  const Region& at(int region) const { return problem_.regions[static_cast<std::size_t>(region)]; }

 private:
  const ExplorationProblem& problem_;
};

unsigned int bits_for(const ExplorationProblem& problem) {
  std::uint32_t greatest = 1;
  for (const Region& region : problem.regions) greatest = std::max(greatest, region.symbol);
  for (const auto& row : problem.task.transitions)
    for (const auto& transition : row) greatest = std::max(greatest, transition.symbol);
  unsigned int bits = 0;
  for (; greatest != 0; greatest >>= 1U) ++bits;
  return bits;
}

oc::World world_of(std::uint32_t symbol, unsigned int bits) {  // all of its propositions are set
  oc::World world(bits);
  for (unsigned int i = 0; i < bits; ++i) world[i] = ((symbol >> i) & 1U) != 0;
  return world;
}

class LabelledCells : public oc::PropositionalDecomposition {
 public:
  LabelledCells(std::shared_ptr<Cells> cells, unsigned int bits)
      : PropositionalDecomposition(cells), cells_(std::move(cells)), bits_(bits) {}
  oc::World worldAtRegion(int region) override {
    return region < 0 ? oc::World(bits_)
                      : world_of(cells_->at(region).symbol, bits_);  // nothing set: no guard holds
  }
  int getNumProps() const override { return static_cast<int>(bits_); }

 private:
  std::shared_ptr<Cells> cells_;
  unsigned int bits_;
};

class Dynamics : public oc::StatePropagator {
 public:
  Dynamics(const oc::SpaceInformationPtr& space, const ExplorationProblem& problem)
      : StatePropagator(space), problem_(problem) {}
  void propagate(const ob::State* from, const oc::Control* control, double, ob::State* to) const override {
    const double* values = control->as<Control>()->values;
    const Configuration here = configuration_of(from), there = stepped(problem_, here, values[0], values[1]);
    set(to, there);
    if (!problem_.is_free(here, configuration_of(to)))
      to->as<State>()->setX(
          std::numeric_limits<double>::quiet_NaN());  // the one sign that a step was not valid
  }

 private:
  const ExplorationProblem& problem_;
};

oc::AutomatonPtr automaton_of(const SymbolAutomaton& task, unsigned int bits) {
  auto automaton = std::make_shared<oc::Automaton>(bits, static_cast<unsigned int>(task.transitions.size()));
  for (unsigned int q = 0; q < task.transitions.size(); ++q) {
    automaton->setAccepting(q, task.accepting[q]);
    for (const auto& transition : task.transitions[q])
      automaton->addTransition(q, world_of(transition.symbol, bits), transition.target);
  }
  automaton->setStartState(task.start);
  return automaton;
}

oc::SpaceInformationPtr make_space(const ExplorationProblem& problem, const ob::RealVectorBounds& bounds) {
  const auto states = std::make_shared<ob::SE2StateSpace>();
  states->setBounds(bounds);
  const auto controls = std::make_shared<oc::RealVectorControlSpace>(states, 2);
  ob::RealVectorBounds limits(2);
  limits.setLow(-1);
  limits.setHigh(1);
  controls->setBounds(limits);
  auto space = std::make_shared<oc::SpaceInformation>(states, controls);
  space->setStateValidityChecker(
      [](const ob::State* state) { return !std::isnan(state->as<State>()->getX()); });
  space->setStatePropagator(std::make_shared<Dynamics>(space, problem));
  space->setMinMaxControlDuration(1, most_steps);
  space->setPropagationStepSize(1);
  space->setup();
  return space;
}

// The steps that OMPL took, one by one, as it took them.
std::vector<Configuration> line_of(const oc::PathControl& path, const ExplorationProblem& problem) {
  std::vector<Configuration> line{problem.start};
  const auto scratch = path.getSpaceInformation()->allocState();
  for (std::size_t i = 0; i < path.getControlCount(); ++i) {
    const double* values = path.getControl(static_cast<unsigned int>(i))->as<Control>()->values;
    const auto steps = std::lround(path.getControlDuration(static_cast<unsigned int>(i)));
    for (long k = 0; k < steps; ++k) {
      set(scratch, stepped(problem, line.back(), values[0], values[1]));
      line.push_back(configuration_of(scratch));
    }
  }
  path.getSpaceInformation()->freeState(scratch);
  return line;
}

}  // namespace

bool has_run(const ExplorationProblem& problem) {
  const auto start = problem.region_of(problem.start);
  if (!start) return false;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen{{*start, problem.task.start}};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open(seen.begin(), seen.end());
  while (!open.empty()) {
    const auto [region, state] = open.back();
    open.pop_back();
    if (problem.task.accepting[state]) return true;
    for (const int neighbour : problem.regions[region].neighbours) {
      const auto next = static_cast<std::uint32_t>(neighbour);
      for (const auto& transition : problem.task.transitions[state])
        if (transition.symbol == problem.regions[next].symbol && seen.emplace(next, transition.target).second)
          open.emplace_back(next, transition.target);
    }
  }
  return false;
}

std::vector<Configuration> explore(const ExplorationProblem& problem, double seconds, std::uint32_t seed) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(std::max(seed, 1U));
  ob::RealVectorBounds bounds(2);
  bounds.low = {problem.low.x, problem.low.y};
  bounds.high = {problem.high.x, problem.high.y};
  const oc::SpaceInformationPtr space = make_space(problem, bounds);
  const unsigned int bits = bits_for(problem);
  const auto cells = std::make_shared<LabelledCells>(std::make_shared<Cells>(problem, bounds), bits);
  const auto product = std::make_shared<oc::ProductGraph>(cells, automaton_of(problem.task, bits));
  const auto product_space = std::make_shared<oc::LTLSpaceInformation>(space, product);
  product_space->setup();
  const auto definition = std::make_shared<oc::LTLProblemDefinition>(product_space);
  ob::ScopedState<ob::SE2StateSpace> start(space);
  set(start.get(), problem.start);
  definition->addLowerStartState(start.get());
  oc::LTLPlanner planner(product_space, product, explore_seconds);
  planner.setProblemDefinition(definition);
  planner.solve(ob::timedPlannerTerminationCondition(seconds));
  if (!definition->hasSolution()) return {};
  const auto path = definition->getLowerSolutionPath();
  return line_of(*path->as<oc::PathControl>(), problem);
}

}  // namespace waymark::plan
