// How fast do learners learn? One three-waypoint task on the map grid; rates per second on one core, exploring, acting
// and updating included, the exact values at checkpoints left out.
//
//   q_learning      one update a step
//   counterfactual  one update a step for every open state of the automaton
//   replayed        the same with 16 past experiences updated again after every step
//   deep            one environment step and one gradient step on a batch of 32, by what the network sees
#include <benchmark/benchmark.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/learn/comparison.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::plan {
namespace {

struct Workload {
  Workload() : map(read_map("grid", WAYMARK_SOURCE_DIR "/data")), arena(map.vocabulary()) {
    const ltl::Formula phi = ltl::parse("F (easel & X F (sofa & X F hatrack))", arena);
    product = tabulate(map, automata::ltlf_to_dfa(phi), map.find({1, 9, 0}).value());
    trees = trees_of(product.task, phi);
  }
  Map map;
  ltl::Arena arena;
  TabularProduct product;
  TaskTrees trees;
};

const Workload& workload() {
  static const Workload work;
  return work;
}

Training training(std::size_t steps) { return {.steps = steps, .interval = steps, .horizon = 200}; }

void tabular(benchmark::State& state, const QLearning& method) {
  constexpr std::size_t steps = 1'000'000;
  std::size_t updates = 0, taken = 0;
  for (auto _ : state) {
    updates += learn(workload().product, method, training(steps)).curve.updates;
    taken += steps;
  }
  state.counters["updates"] = benchmark::Counter(static_cast<double>(updates), benchmark::Counter::kIsRate);
  state.counters["steps"] = benchmark::Counter(static_cast<double>(taken), benchmark::Counter::kIsRate);
}

void deep(benchmark::State& state, Sight sight, const Dqn& method, bool with_trees) {
  constexpr std::size_t steps = 20'000;
  const Observations seen = observe(workload().map, sight);
  Training half_random = training(steps);
  half_random.explore = 1;
  half_random.explore_steps = steps / 2;
  std::size_t taken = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        learn(workload().product, {&seen.by_position, with_trees ? &workload().trees : nullptr}, method, half_random));
    taken += steps;
  }
  state.counters["steps"] = benchmark::Counter(static_cast<double>(taken), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(tabular, q_learning, QLearning{});
BENCHMARK_CAPTURE(tabular, counterfactual, QLearning{.counterfactual = true});
BENCHMARK_CAPTURE(tabular, replayed, QLearning{.counterfactual = true, .replays = 16});
BENCHMARK_CAPTURE(deep, objects, Sight::Objects, Dqn{}, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(deep, landmarks, Sight::Landmarks, Dqn{}, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(deep, landmarks_double, Sight::Landmarks, Dqn{.double_q = true}, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(deep, landmarks_trees, Sight::Landmarks, Dqn{}, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace waymark::plan
