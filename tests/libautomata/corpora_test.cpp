// State counts on the open benchmark sets beside the repository: equal to the minimal counts that the peers report
// (facts/README.md). Skipped, loudly, where the sets are missing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/benchmark_sets.hpp"

namespace waymark::automata {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

// Column `name` of a table with a header row, as text.
std::vector<std::string> column(const fs::path& path, const std::string& name) {
  std::vector<std::string> out;
  std::size_t index = SIZE_MAX;
  for (const std::string& line : lines(path)) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    if (index == SIZE_MAX) {
      index = static_cast<std::size_t>(std::find(row.begin(), row.end(), name) - row.begin());
      EXPECT_LT(index, row.size()) << "no column " << name << " in " << path;
    } else {
      out.push_back(index < row.size() ? row[index] : "?");
    }
  }
  return out;
}

class Corpora : public ::testing::TestWithParam<const char*> {};

TEST_P(Corpora, HaveTheMinimalNumberOfStates) {
  const fs::path folder = testing::benchmark_sets();
  const std::string set = GetParam();
  if (!fs::exists(folder / (set + ".ltlf")))
    GTEST_SKIP() << "benchmark formulas not found: " << folder / (set + ".ltlf") << " (set WAYMARK_SHARED)";
  const std::vector<std::string> formulas = lines(folder / (set + ".ltlf"));
  const std::vector<std::string> expected = column(folder / "facts" / (set + ".tsv"), "min_complete_dfa_states");
  std::size_t compared = 0;
  for (std::size_t i = 0; i < formulas.size() && i < expected.size(); ++i) {
    if (expected[i].find_first_not_of("0123456789") != std::string::npos) continue;  // TO, ? or -: no fact
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(formulas[i], arena, {.dialect = ltl::Dialect::Spot});
    EXPECT_EQ(std::to_string(ltlf_to_dfa(f).states()), expected[i]) << set << ":" << i + 1;
    ++compared;
  }
  EXPECT_GT(compared, 0U);
  RecordProperty("compared", std::to_string(compared));
}

// The sets that translate in milliseconds; the large ones are measured by the benchmark translate_bench.
INSTANTIATE_TEST_SUITE_P(Ltlf, Corpora,
                         ::testing::Values("ltlf_families", "ltlf_dwyer", "ltlf_declare", "ltlf_declare_models",
                                           "ltlf_patterns_u_gf", "ltlf_random4", "ltlf_random6"),
                         [](const auto& set) { return std::string(set.param); });

}  // namespace
}  // namespace waymark::automata
