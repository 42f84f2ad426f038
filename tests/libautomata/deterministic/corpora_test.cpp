// Deterministic parity automata of the open benchmark sets beside the repository: no line has more states than the
// smaller one of Spot's and Owl's automata in facts/, and each set stays at the size that it has reached. Skipped,
// loudly, where sets are missing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/benchmark_sets.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;
using testing::column;

struct Gate {
  const char* set;
  std::size_t states;  // summed over all lines, at most
  friend void PrintTo(const Gate& gate, std::ostream* out) { *out << gate.set; }
};
class ParityCorpora : public ::testing::TestWithParam<Gate> {};

TEST_P(ParityCorpora, AreNoLargerThanTheirPeersLineByLine) {
  const fs::path folder = testing::benchmark_sets(), path = folder / (std::string(GetParam().set) + ".ltl");
  if (!fs::exists(path)) GTEST_SKIP() << "benchmark formulas not found: " << path << " (set WAYMARK_SHARED)";
  const fs::path facts = folder / "facts" / GetParam().set;
  const auto spot = column(facts.string() + ".tsv", "dpa_states");
  const auto owl = column(facts.string() + ".owl.tsv", "owl_dpa_states");
  ASSERT_FALSE(spot.empty()) << facts;
  std::ifstream in(path);
  ltl::Random random(1);
  std::size_t states = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (testing::sanitized && number % 20 != 1) continue;
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(line, arena);
    const Dpa dpa = ltl_to_dpa(f);
    states += dpa.automaton().states();
    for (const auto* peer : {&spot, &owl})
      if (const auto known = peer->find(number); known != peer->end()) {
        EXPECT_LE(dpa.automaton().states(), known->second) << path << ":" << number << ' ' << line;
      }
    for (int i = 0; i < 10; ++i) {
      const ltl::Lasso word = ltl::random_lasso(
          random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = arena.vocabulary().size()});
      ASSERT_EQ(accepts(dpa.automaton(), word), ltl::holds(word, f))
          << path << ":" << number << " on " << ltl::show(word, arena.vocabulary());
    }
  }
  if (testing::sanitized) return;
  EXPECT_LE(states, GetParam().states);
}

INSTANTIATE_TEST_SUITE_P(Ltl, ParityCorpora,
                         ::testing::Values(Gate{"ltl_dwyer", 101}, Gate{"ltl_etessami_holzmann", 21},
                                           Gate{"ltl_somenzi_bloem", 38}, Gate{"ltl_pelanek_beem", 21},
                                           Gate{"ltl_liberouter", 111}, Gate{"ltl_lily", 154},
                                           Gate{"ltl_families", 978}, Gate{"ltl_random4", 3331}),
                         [](const auto& gate) { return std::string(gate.param.set); });

}  // namespace
}  // namespace waymark::automata
