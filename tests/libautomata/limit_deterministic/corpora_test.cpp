// Limit-deterministic automata of the open benchmark sets beside the repository: each set stays at the size that it has
// reached, and no line has more states than Owl's in facts/. Skipped, loudly, where sets are missing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/omega/emptiness.hpp"
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
  std::size_t states;  // summed over the lines that Owl answers, at most
  friend void PrintTo(const Gate& gate, std::ostream* out) { *out << gate.set; }
};
class LdbaCorpora : public ::testing::TestWithParam<Gate> {};

TEST_P(LdbaCorpora, AreNoLargerThanOwlsLineByLine) {
  const fs::path folder = testing::benchmark_sets(), path = folder / (std::string(GetParam().set) + ".ltl");
  if (!fs::exists(path)) GTEST_SKIP() << "benchmark formulas not found: " << path << " (set WAYMARK_SHARED)";
  const auto owl = testing::column(folder / "facts" / (std::string(GetParam().set) + ".owl.tsv"), "owl_ldba_states");
  ASSERT_FALSE(owl.empty());
  std::ifstream in(path);
  ltl::Random random(1);
  std::size_t states = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (testing::sanitized && number % 20 != 1) continue;
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(line, arena);
    const MdpSafe ldba = ltl_to_ldba(f);
    if (const auto known = owl.find(number); known != owl.end()) {
      states += ldba.states();
      EXPECT_LE(ldba.states(), known->second) << path << ":" << number << ' ' << line;
    }
    for (int i = 0; i < 10; ++i) {
      const ltl::Lasso word = ltl::random_lasso(
          random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = arena.vocabulary().size()});
      ASSERT_EQ(accepts(ldba.automaton(), word), ltl::holds(word, f))
          << path << ":" << number << " on " << ltl::show(word, arena.vocabulary());
    }
  }
  if (testing::sanitized) return;
  EXPECT_LE(states, GetParam().states);
}

INSTANTIATE_TEST_SUITE_P(Ltl, LdbaCorpora,
                         ::testing::Values(Gate{"ltl_dwyer", 107}, Gate{"ltl_etessami_holzmann", 23},
                                           Gate{"ltl_somenzi_bloem", 41}, Gate{"ltl_pelanek_beem", 23},
                                           Gate{"ltl_liberouter", 111}, Gate{"ltl_lily", 169},
                                           Gate{"ltl_random4", 3691}),
                         [](const auto& gate) { return std::string(gate.param.set); });

}  // namespace
}  // namespace waymark::automata
