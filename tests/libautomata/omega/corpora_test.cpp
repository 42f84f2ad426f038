// Sizes on the open benchmark sets beside the repository, gated where they stand: a change that makes a set larger
// shows here. What the peers have is in facts/ and in the benchmark ltl_bench. Skipped, loudly, where sets are missing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/benchmark_sets.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;

struct Gate {
  const char* set;
  std::size_t tgba_states, tgba_edges, buchi_states, buchi_edges;  // summed, at most
  friend void PrintTo(const Gate& gate, std::ostream* out) { *out << gate.set; }
};
class BuchiCorpora : public ::testing::TestWithParam<Gate> {};

TEST_P(BuchiCorpora, HaveTheirSizesAndTheirLanguages) {
  const fs::path path = testing::benchmark_sets() / (std::string(GetParam().set) + ".ltl");
  if (!fs::exists(path)) GTEST_SKIP() << "benchmark formulas not found: " << path << " (set WAYMARK_SHARED)";
  std::ifstream in(path);
  ltl::Random random(1);
  std::size_t general_states = 0, general_edges = 0, buchi_states = 0, buchi_edges = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (testing::sanitized && number % 10 != 1) continue;  // slow there; sizes are for the whole set, in release
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(line, arena);
    const Automaton general = ltl_to_tgba(f), buchi = ltl_to_buchi(f);
    general_states += general.states();
    general_edges += count_edges(general.transitions());
    buchi_states += buchi.states();
    buchi_edges += count_edges(buchi.transitions());
    for (int i = 0; i < 10; ++i) {
      const ltl::Lasso word = ltl::random_lasso(
          random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = arena.vocabulary().size()});
      ASSERT_EQ(accepts(general, word), ltl::holds(word, f))
          << path << ":" << number << " on " << ltl::show(word, arena.vocabulary());
      ASSERT_EQ(accepts(buchi, word), ltl::holds(word, f))
          << path << ":" << number << " on " << ltl::show(word, arena.vocabulary());
    }
  }
  if (testing::sanitized) return;
  EXPECT_LE(general_states, GetParam().tgba_states);
  EXPECT_LE(general_edges, GetParam().tgba_edges);
  EXPECT_LE(buchi_states, GetParam().buchi_states);
  EXPECT_LE(buchi_edges, GetParam().buchi_edges);
}

INSTANTIATE_TEST_SUITE_P(
    Ltl, BuchiCorpora,
    ::testing::Values(Gate{"ltl_dwyer", 100, 261, 103, 273}, Gate{"ltl_etessami_holzmann", 18, 36, 22, 44},
                      Gate{"ltl_somenzi_bloem", 39, 76, 45, 88}, Gate{"ltl_pelanek_beem", 22, 49, 25, 56},
                      Gate{"ltl_liberouter", 92, 404, 119, 785}, Gate{"ltl_lily", 139, 720, 150, 750},
                      Gate{"ltl_families", 935, 5228, 992, 5260}, Gate{"ltl_random4", 2943, 7670, 3192, 8464}),
    [](const auto& gate) { return std::string(gate.param.set); });

}  // namespace
}  // namespace waymark::automata
