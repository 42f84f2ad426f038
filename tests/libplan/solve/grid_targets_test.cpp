// Where any choice may lead, asked at once: on products of grids the same as the outcomes of each choice, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <sstream>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tests/libplan/solve/random_grids.hpp"

namespace waymark::plan {
namespace {

using Product = ProductMdp<GridWorld>;

void expect_same_targets(const Product& product, const std::string& what) {
  std::vector<std::set<std::uint32_t>> sources(product.states());
  std::uint64_t edges = 0;
  product.for_each_state([&](const Product::State& s) {
    std::set<std::uint32_t> outcomes, targets;
    for (std::uint32_t k = 0; k < product.choices(s); ++k)
      product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) {
        outcomes.insert(t);
        if (t == Product::trap) return;
        sources[t].insert(s.index);
        ++edges;
      });
    product.for_each_target(s, [&](std::uint32_t t) { targets.insert(t); });
    EXPECT_EQ(targets, outcomes) << what << "  state " << s.index;
  });
  EXPECT_EQ(product.edges(), edges) << what;
  product.for_each_state([&](const Product::State& s) {
    std::set<std::uint32_t> told;
    product.for_each_predecessor(s, [&](const Product::State& source) { told.insert(source.index); });
    EXPECT_TRUE(std::includes(told.begin(), told.end(), sources[s.index].begin(), sources[s.index].end()))
        << what << "  state " << s.index;
  });
}

TEST(GridTargets, AreTheOutcomesOfAllChoices) {
  constexpr std::uint64_t seed = 74;
  ltl::Random random(seed);
  std::size_t jumps = 0;
  for (int round = 0; round < 60; ++round) {
    const GridWorld grid = testing::noisy_grid(random);
    for (const char* text : {"F (a & F b)", "!x U a & F b", "G F a & G !x", "F G a", "G (a -> X F b)"}) {
      ltl::Arena arena(grid.letters().vocabulary());
      const auto automaton =
          task_automaton(ltl::parse(text, arena), CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability, {});
      ASSERT_TRUE(automaton) << text;
      const TaskTable task = std::visit([&](const auto& a) { return TaskTable(a, grid.letters()); }, *automaton);
      const auto product = Product::explore(grid, task);
      ASSERT_TRUE(product);
      for (std::uint32_t q = 0; q < task.states(); ++q) jumps += task.jumps(q).size();
      bool marked = false;
      product->for_each_state([&](const Product::State& s) {
        for (std::uint32_t k = 0; k < product->choices(s); ++k)
          product->for_each_outcome(s, k, [&](std::uint32_t, double, bool mark) { marked = marked || mark; });
      });
      EXPECT_TRUE(!marked || product->has_marks()) << text << "  round " << round << "  seed " << seed;
      expect_same_targets(*product, text + ("  round " + std::to_string(round)) + "  seed " + std::to_string(seed));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(jumps, 0U) << "else no jump was looked at";
}

}  // namespace
}  // namespace waymark::plan
