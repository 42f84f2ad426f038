// How long does one plan take? Random (start, task) pairs on a SAIL map, tasks of one to three nested steps, translated
// beforehand: what a learner asks for thousands of times.
//
//   planner per pair     a fresh RoutePlanner each time: classes and steps from nothing
//   planner per task     one RoutePlanner per task, asked about every start
//   built product        compose, then solve by A* or Dijkstra
// Counters: vertices expanded (by planners: pairs met) per plan, which is repeatable, and plans per second.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libplan/plan_of.hpp"
#include "libplan/solve/route_planner.hpp"
#include "libplan/solve/shortest_route.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::plan {
namespace {

struct Pair {
  PoseId start;
  std::size_t task;
};

// Tasks are X(l₁ ∧ l₂) or F(l₁ ∧ l₂) steps, each with the next one nested inside; only feasible pairs are kept.
struct Workload {
  explicit Workload(std::size_t steps) : map(read_map("grid", WAYMARK_SOURCE_DIR "/data")), arena(map.vocabulary()) {
    ltl::Random random(1);
    while (tasks.size() < 64) {
      const ltl::Formula f = task(random, steps);
      const automata::Dfa dfa = automata::ltlf_to_dfa(f);
      if (dfa.is_trap(dfa.initial())) continue;
      formulas.push_back(f);
      tasks.push_back(dfa);
    }
    while (pairs.size() < 512) {
      const Pair pair{PoseId{static_cast<std::uint32_t>(random.below(map.poses()))}, random.below(tasks.size())};
      if (std::holds_alternative<Route>(RoutePlanner(map, tasks[pair.task]).plan(pair.start))) pairs.push_back(pair);
    }
  }

  ltl::Formula literal(ltl::Random& random) {
    const auto p = static_cast<std::uint32_t>(random.below(map.vocabulary().size()));
    return arena.atom(ltl::Proposition{p});
  }
  ltl::Formula task(ltl::Random& random, std::size_t steps) {
    ltl::Formula f = literal(random);
    if (random.chance(0.5)) f = ltl::conjunction(f, literal(random));
    if (steps > 1) f = ltl::conjunction(f, task(random, steps - 1));
    return random.chance(0.3) ? ltl::next(f) : ltl::eventually(f);
  }

  Map map;
  ltl::Arena arena;
  std::vector<ltl::Formula> formulas;
  std::vector<automata::Dfa> tasks;
  std::vector<Pair> pairs;
};

Workload& workload(std::size_t steps) {
  static std::vector<std::unique_ptr<Workload>> made(8);
  if (!made.at(steps)) made[steps] = std::make_unique<Workload>(steps);
  return *made[steps];
}

// Runs `plan` on the pairs in turn; it returns the vertices expanded.
template <class Plan>
void run(benchmark::State& state, Plan plan) {
  Workload& work = workload(static_cast<std::size_t>(state.range(0)));
  std::size_t next = 0, expanded = 0, plans = 0;
  for (auto _ : state) {
    expanded += plan(work, work.pairs[next]);
    next = (next + 1) % work.pairs.size();
    ++plans;
  }
  state.counters["expanded"] = benchmark::Counter(static_cast<double>(expanded) / static_cast<double>(plans));
  state.counters["plans"] = benchmark::Counter(static_cast<double>(plans), benchmark::Counter::kIsRate);
}

void planner_per_pair(benchmark::State& state) {
  run(state, [](Workload& work, const Pair& pair) {
    RoutePlanner planner(work.map, work.tasks[pair.task]);
    benchmark::DoNotOptimize(planner.plan(pair.start));
    return planner.met();
  });
}

void planner_per_task(benchmark::State& state) {
  std::vector<std::unique_ptr<RoutePlanner>> planners(workload(static_cast<std::size_t>(state.range(0))).tasks.size());
  run(state, [&](Workload& work, const Pair& pair) {
    auto& planner = planners[pair.task];
    if (!planner) planner = std::make_unique<RoutePlanner>(work.map, work.tasks[pair.task]);
    benchmark::DoNotOptimize(planner->plan(pair.start));
    return planner->met();
  });
}

template <ShortestRoute::Algorithm algorithm>
void built_product(benchmark::State& state) {
  run(state, [](Workload& work, const Pair& pair) {
    const MapProduct product = compose(work.map, work.tasks[pair.task], pair.start);
    return std::get<Solved>(solve(product, {.algorithm = algorithm})).expanded;
  });
}

// Translation and certificate included: what `waymark plan` does.
void formula_to_certified_route(benchmark::State& state) {
  run(state, [](Workload& work, const Pair& pair) {
    benchmark::DoNotOptimize(plan_of(work.map, work.formulas[pair.task], pair.start));
    return std::size_t{0};
  });
}

BENCHMARK(planner_per_pair)->DenseRange(1, 3)->ArgName("steps")->Unit(benchmark::kMicrosecond);
BENCHMARK(planner_per_task)->DenseRange(1, 3)->ArgName("steps")->Unit(benchmark::kMicrosecond);
BENCHMARK(built_product<ShortestRoute::Algorithm::AStar>)
    ->DenseRange(1, 3)
    ->ArgName("steps")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(built_product<ShortestRoute::Algorithm::Dijkstra>)
    ->DenseRange(1, 3)
    ->ArgName("steps")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(formula_to_certified_route)->DenseRange(1, 3)->ArgName("steps")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace waymark::plan
