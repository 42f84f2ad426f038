// What does a table from pairs of numbers cost, beside the standard library's? Pairs as a walk of two diagrams meets
// them: each is looked for three times and stored once; then the table is emptied.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libltl/rewriting/pair_memo.hpp"
#include "libltl/structure/random.hpp"

namespace waymark {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_to_meet(std::size_t different) {
  ltl::Random random(1);
  Pairs out;
  for (std::size_t i = 0; i < 4 * different; ++i)
    out.emplace_back(static_cast<std::uint32_t>(random.below(different)), static_cast<std::uint32_t>(random.below(3)));
  return out;
}

void pair_memo(benchmark::State& state) {
  const Pairs pairs = pairs_to_meet(static_cast<std::size_t>(state.range(0)));
  ltl::PairMemo<std::uint32_t> table;
  for (auto _ : state) {
    std::uint32_t fresh = 0;
    for (const auto& [x, y] : pairs)
      if (table.find(x, y) == nullptr) table.store(x, y, fresh++);
    benchmark::DoNotOptimize(fresh);
    table.clear();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(pairs.size()) * state.iterations());
}

void unordered_map(benchmark::State& state) {
  const Pairs pairs = pairs_to_meet(static_cast<std::size_t>(state.range(0)));
  std::unordered_map<std::uint64_t, std::uint32_t> table;
  for (auto _ : state) {
    std::uint32_t fresh = 0;
    for (const auto& [x, y] : pairs)
      if (table.try_emplace(std::uint64_t{x} << 32U | y, fresh).second) ++fresh;
    benchmark::DoNotOptimize(fresh);
    table.clear();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(pairs.size()) * state.iterations());
}

BENCHMARK(pair_memo)->Arg(20)->Arg(1'000)->Arg(100'000);
BENCHMARK(unordered_map)->Arg(20)->Arg(1'000)->Arg(100'000);

}  // namespace
}  // namespace waymark
