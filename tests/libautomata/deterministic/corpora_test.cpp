// Deterministic parity automata of the open benchmark sets beside the repository: no line has more states than the
// smaller one of Spot's and Owl's automata in facts/, and each set stays at the size that it has reached. Skipped,
// loudly, where sets are missing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "libautomata/deterministic/ltl_to_parity.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libltl/parse.hpp"
#include "libltl/random.hpp"
#include "libltl/semantics.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;

fs::path shared() {
  if (const char* place = std::getenv("WAYMARK_SHARED")) return place;
  fs::path root = __FILE__;
  for (int up = 0; up < 5; ++up) root = root.parent_path();
  return root / "shared";
}

// By line: the number in a column, where there is one.
std::map<std::size_t, std::size_t> column(const fs::path& path, const std::string& name) {
  std::map<std::size_t, std::size_t> out;
  std::ifstream in(path);
  std::string line, cell;
  std::getline(in, line);
  std::istringstream head(line);
  std::size_t at = 0;
  while (std::getline(head, cell, '\t') && cell != name) ++at;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream row(line);
    for (std::size_t i = 0; i <= at; ++i) std::getline(row, cell, '\t');
    if (!cell.empty() && cell.find_first_not_of("0123456789") == std::string::npos)
      out[number] = std::stoul(cell);
  }
  return out;
}

struct Gate {
  const char* set;
  std::size_t states;  // summed over all lines, at most
};
class ParityCorpora : public ::testing::TestWithParam<Gate> {};

TEST_P(ParityCorpora, AreNoLargerThanTheirPeersLineByLine) {
  const fs::path folder = shared() / "ltl", path = folder / (std::string(GetParam().set) + ".ltl");
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
          random,
          {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = arena.vocabulary().size()});
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
                                           Gate{"ltl_families", 978}, Gate{"ltl_random4", 3332}),
                         [](const auto& gate) { return std::string(gate.param.set); });

}  // namespace
}  // namespace waymark::automata
