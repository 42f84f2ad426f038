// How long does it take to say whether a trajectory of 64 positions satisfies a formula?
//
// Four engines on the same formulas and trajectories; the counter `per_subformula_64` is the time of one answer
// over the number of subformulas of the formula (not over the engine's own steps), so that the rows compare.
// Formulas: instructions as the parser writes them, and random ones. The automaton's translation is not counted.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::ltl {
namespace {

constexpr std::size_t positions = 64, atoms = 6, trajectories = 32;

struct Bench {
  Arena arena{Vocabulary({"chair", "sofa", "lamp", "blue", "moved", "turned_left"})};
  std::vector<Formula> formulas;
  std::vector<Trace> words;
  std::vector<Columns> columns;
  std::size_t subformula_count = 0;  // over all formulas
};

std::unique_ptr<Bench> instructions() {
  auto out = std::make_unique<Bench>();
  for (const char* text :
       {"F chair", "F(chair & F sofa)", "X(turned_left & F(sofa & blue))", "X(moved U (moved & chair))",
        "F(blue & X(turned_left & X(moved U (moved & lamp))))", "G !sofa & F(chair & F lamp)",
        "X(moved & X(moved & X(moved & X turned_left)))", "(!sofa U chair) & F(lamp & N false)"})
    out->formulas.push_back(parse(text, out->arena));
  return out;
}

std::unique_ptr<Bench> random_formulas() {
  auto out = std::make_unique<Bench>();
  Random random(1);
  for (int i = 0; i < 32; ++i)
    out->formulas.push_back(random_formula(random, out->arena, {.size = 12, .atoms = atoms}));
  return out;
}

std::unique_ptr<Bench> with_words(std::unique_ptr<Bench> bench) {
  Random random(2);
  for (std::size_t i = 0; i < trajectories; ++i) {
    bench->words.push_back(random_trace(random, {.length = positions, .atoms = atoms, .density = 0.3}));
    bench->columns.emplace_back(bench->words.back(), atoms);
  }
  for (Formula f : bench->formulas) bench->subformula_count += subformulas(f).size();
  return bench;
}

std::unique_ptr<Bench> bench_of(const benchmark::State& state) {
  return with_words(state.range(0) == 0 ? instructions() : random_formulas());
}

// One round of the loop answers every formula on every trajectory.
void report(benchmark::State& state, const Bench& bench) {
  state.SetLabel(state.range(0) == 0 ? "instructions" : "random");
  const double answers = static_cast<double>(bench.formulas.size() * trajectories);
  const double work = static_cast<double>(bench.subformula_count * trajectories);
  state.counters["answers"] = benchmark::Counter(answers, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["per_subformula_64"] =
      benchmark::Counter(work, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void trace_check(benchmark::State& state) {
  const auto bench = bench_of(state);
  std::vector<TraceCheck> checks;
  for (Formula f : bench->formulas) checks.emplace_back(f);
  for (auto _ : state)
    for (const Columns& word : bench->columns)
      for (TraceCheck& check : checks) benchmark::DoNotOptimize(check(word));
  report(state, *bench);
}
BENCHMARK(trace_check)->Arg(0)->Arg(1);

void trace_check_shared_by_all_formulas(benchmark::State& state) {
  const auto bench = bench_of(state);
  TraceCheck check(bench->formulas);
  const std::unique_ptr<bool[]> verdicts(new bool[bench->formulas.size()]);
  for (auto _ : state)
    for (const Columns& word : bench->columns) {
      check.check(word, {verdicts.get(), bench->formulas.size()});
      benchmark::DoNotOptimize(verdicts[0]);
    }
  report(state, *bench);
}
BENCHMARK(trace_check_shared_by_all_formulas)->Arg(0)->Arg(1);

void trace_check_building_columns_each_time(benchmark::State& state) {
  const auto bench = bench_of(state);
  std::vector<TraceCheck> checks;
  for (Formula f : bench->formulas) checks.emplace_back(f);
  for (auto _ : state)
    for (const Trace& word : bench->words)
      for (TraceCheck& check : checks) benchmark::DoNotOptimize(check(Columns(word, atoms)));
  report(state, *bench);
}
BENCHMARK(trace_check_building_columns_each_time)->Arg(0)->Arg(1);

void dfa_run(benchmark::State& state) {
  const auto bench = bench_of(state);
  std::vector<automata::Dfa> dfas;
  for (Formula f : bench->formulas) dfas.push_back(automata::ltlf_to_dfa(f));
  for (auto _ : state)
    for (const Trace& word : bench->words)
      for (const automata::Dfa& dfa : dfas) benchmark::DoNotOptimize(automata::accepts(dfa, word));
  report(state, *bench);
}
BENCHMARK(dfa_run)->Arg(0)->Arg(1);

void progression(benchmark::State& state) {
  const auto bench = bench_of(state);
  for (auto _ : state)
    for (const Trace& word : bench->words)
      for (Formula f : bench->formulas) {
        Formula rest = f;
        for (const Letter& letter : word) rest = progress(rest, letter);
        benchmark::DoNotOptimize(accepts_empty(rest));
      }
  report(state, *bench);
}
BENCHMARK(progression)->Arg(0)->Arg(1);

}  // namespace
}  // namespace waymark::ltl
