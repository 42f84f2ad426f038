// Sizes on the open benchmark sets beside the repository, gated where they stand: a change that makes a set larger
// shows here. What the peers have is in facts/ and in the benchmark ltl_bench. Skipped, loudly, where sets are missing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/ltl_to_buchi.hpp"
#include "libltl/parse.hpp"
#include "libltl/random.hpp"
#include "libltl/semantics.hpp"
#include "tests/support/benchmark_sets.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;

struct Gate {
  const char* set;
  std::size_t tgba_states, buchi_states;  // summed, at most
  friend void PrintTo(const Gate& gate, std::ostream* out) { *out << gate.set; }
};
class BuchiCorpora : public ::testing::TestWithParam<Gate> {};

TEST_P(BuchiCorpora, HaveTheirSizesAndTheirLanguages) {
  const fs::path path = testing::benchmark_sets() / (std::string(GetParam().set) + ".ltl");
  if (!fs::exists(path)) GTEST_SKIP() << "benchmark formulas not found: " << path << " (set WAYMARK_SHARED)";
  std::ifstream in(path);
  ltl::Random random(1);
  std::size_t general_states = 0, buchi_states = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (testing::sanitized && number % 10 != 1)
      continue;  // slow there; sizes are for the whole set, in release
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(line, arena);
    const Automaton general = ltl_to_tgba(f), buchi = ltl_to_buchi(f);
    general_states += general.states();
    buchi_states += buchi.states();
    for (int i = 0; i < 10; ++i) {
      const ltl::Lasso word = ltl::random_lasso(
          random,
          {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = arena.vocabulary().size()});
      ASSERT_EQ(accepts(general, word), ltl::holds(word, f))
          << path << ":" << number << " on " << ltl::show(word, arena.vocabulary());
      ASSERT_EQ(accepts(buchi, word), ltl::holds(word, f))
          << path << ":" << number << " on " << ltl::show(word, arena.vocabulary());
    }
  }
  if (testing::sanitized) return;
  EXPECT_LE(general_states, GetParam().tgba_states);
  EXPECT_LE(buchi_states, GetParam().buchi_states);
}

INSTANTIATE_TEST_SUITE_P(Ltl, BuchiCorpora,
                         ::testing::Values(Gate{"ltl_dwyer", 105, 106}, Gate{"ltl_etessami_holzmann", 19, 23},
                                           Gate{"ltl_somenzi_bloem", 40, 45},
                                           Gate{"ltl_pelanek_beem", 23, 26}, Gate{"ltl_liberouter", 93, 126},
                                           Gate{"ltl_lily", 155, 168}, Gate{"ltl_families", 945, 1004},
                                           Gate{"ltl_random4", 3338, 3607}),
                         [](const auto& gate) { return std::string(gate.param.set); });

}  // namespace
}  // namespace waymark::automata
