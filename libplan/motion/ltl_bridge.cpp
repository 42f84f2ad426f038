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
#include <stdexcept>

namespace waymark::plan {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;
using State = ob::SE2StateSpace::StateType;
using Control = oc::RealVectorControlSpace::ControlType;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double turn_step = 15,
                 bend_step = 6;   // degrees that a disc turns in a step in place, and as it goes
constexpr double backing = -0.6;  // below that a car goes backwards and a disc turns in place
constexpr unsigned int most_steps = 12;
constexpr double explore_seconds = 0.02;  // along one lead, before another one is computed

Configuration configuration_of(const ob::State* state) {
  const auto& pose = *state->as<State>();
  return {pose.getX(), pose.getY(), normalized(pose.getYaw() / degree + quarter_turn)};
}

void set(ob::State* state, const Configuration& c) {
  auto& pose = *state->as<State>();
  pose.setXY(c.x, c.y);
  pose.setYaw(-turn_between(c.heading, quarter_turn) * degree);  // −π ≤ yaw < π, or no start is taken
}

// One step. Both controls are drawn from −1 … 1. Cubed, the second says how sharply to turn, more often little than
// much: a car or a disc bends its way. The first is the speed; for a fifth of it a car backs up, and a disc turns in
// place.
Configuration stepped(const ExplorationProblem& problem, const Configuration& from, double first, double second) {
  const double steering = second * second * second, speed = std::max(0.2, (first + 1) / 2);
  if (const auto* car = std::get_if<Car>(&problem.robot)) {
    const double way = problem.step * (first < backing ? -1 : speed);
    return Piece::driving(from, way, way * steering / car->turning_radius / degree).at(1);
  }
  const bool in_place = first < backing;
  const double turn = in_place ? turn_step * second : bend_step * steering, way = in_place ? 0 : problem.step * speed;
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
    return region < 0 ? oc::World(bits_) : world_of(cells_->at(region).symbol, bits_);  // nothing set: no guard holds
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
      to->as<State>()->setX(std::numeric_limits<double>::quiet_NaN());  // the one sign that a step was not valid
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
  space->setStateValidityChecker([](const ob::State* state) { return !std::isnan(state->as<State>()->getX()); });
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

// A control lasts for several steps, and the task may be done before its last one: what comes after that is cut off.
std::vector<Configuration> until_done(std::vector<Configuration> line, const ExplorationProblem& problem) {
  std::uint32_t state = problem.task.start;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto region = problem.region_of(line[i]);
    if (!region) break;
    const std::uint32_t symbol = problem.regions[*region].symbol;
    const auto& transitions = problem.task.transitions[state];
    const auto next = std::find_if(transitions.begin(), transitions.end(),
                                   [&](const auto& transition) { return transition.symbol == symbol; });
    if (next == transitions.end()) break;
    state = next->target;
    if (!problem.task.accepting[state]) continue;
    line.resize(i + 1);
    break;
  }
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
  const ob::State* first = definition->getStartState(0);
  if (!product_space->satisfiesBounds(first) || !product_space->isValid(first))  // OMPL would follow a null pointer
    throw std::logic_error("explore: the start is no state of the product");
  oc::LTLPlanner planner(product_space, product, explore_seconds);
  planner.setProblemDefinition(definition);
  planner.solve(ob::timedPlannerTerminationCondition(seconds));
  if (!definition->hasSolution()) return {};
  const auto path = definition->getLowerSolutionPath();
  return until_done(line_of(*path->as<oc::PathControl>(), problem), problem);
}

}  // namespace waymark::plan
