// Routes and tours against enumeration.
#include "libplan/solve/product_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "libautomata/ltlf_to_dfa.hpp"
#include "libltl/print.hpp"
#include "libltl/semantics.hpp"
#include "libplan/solve/landmark_tour.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using waymark::testing::scaled;

// The least cost of a route of at most `length` choices whose word satisfies f by definition.
double by_enumeration(const Mdp& mdp, ltl::Formula f, std::uint32_t at, std::vector<ltl::Letter>& word,
                      double cost, std::size_t length) {
  double best = ltl::holds(ltl::Trace(word), f) ? cost : INFINITY;
  if (length == 0) return best;
  for (std::uint32_t k = 0; k < mdp.choices(at); ++k)
    mdp.for_each_outcome(at, k, [&](std::uint32_t t, LetterId letter, double) {
      word.push_back(mdp.letters()[letter]);
      best = std::min(best, by_enumeration(mdp, f, t, word, cost + mdp.cost(at, k), length - 1));
      word.pop_back();
    });
  return best;
}

TEST(ProductSearch, LeastCostsAgreeWithEnumeration) {
  ltl::Random random(8);
  int found = 0;
  for (int i = 0; i < scaled(300); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(7), .atoms = 2});
    const Mdp mdp = testing::random_model(
        random, {.states = 3, .most_choices = 2, .deterministic = true, .unit_costs = random.below(2) == 0});
    const automata::Dfa dfa = automata::ltlf_to_dfa(f);
    const auto answer = search(mdp, TaskTable(dfa, mdp.letters()));
    ASSERT_TRUE(answer);
    std::vector<ltl::Letter> word{mdp.letters()[mdp.initial_letter()]};
    const double expected = by_enumeration(mdp, f, mdp.initial(), word, 0, 8);
    if (!answer->route) {
      EXPECT_TRUE(std::isinf(expected)) << ltl::print(f) << " on\n" << testing::show(mdp);
      continue;
    }
    ++found;
    EXPECT_TRUE(ltl::holds(word_of(mdp, *answer->route), f)) << ltl::print(f) << " on\n"
                                                             << testing::show(mdp);
    if (answer->route->choices.size() <= 8) {
      EXPECT_EQ(answer->route->cost, expected) << ltl::print(f) << " on\n" << testing::show(mdp);
    } else {
      EXPECT_LE(answer->route->cost, expected);
    }
  }
  EXPECT_GT(found, scaled(60));
}

TEST(ProductSearch, RefusesChance) {
  ltl::Random random(9);
  Mdp mdp = testing::random_model(random, {.states = 5});
  while (mdp.is_deterministic()) mdp = testing::random_model(random, {.states = 5});
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Dfa dfa = automata::ltlf_to_dfa(arena.atom("a"));
  EXPECT_THROW(search(mdp, TaskTable(dfa, mdp.letters())), std::invalid_argument);
}

// A random grid with three landmarks, some of them on several cells.
GridWorld random_grid(ltl::Random& random) {
  ltl::Vocabulary vocabulary;
  std::vector<GridCell> palette{{}, {.wall = true}};
  for (const char* name : {"a", "b", "c"}) {
    GridCell& cell = palette.emplace_back();
    cell.label.insert(vocabulary.add(name));
  }
  std::vector<std::uint16_t> cells{0};
  for (int i = 1; i < 20; ++i) {
    const std::size_t r = random.below(10);
    cells.push_back(static_cast<std::uint16_t>(r < 5 ? 0 : r < 7 ? 1 : r - 5));
  }
  return GridWorld({.width = 5, .height = 4}, vocabulary, palette, cells, 0);
}

// All pairs by relaxation, at least one move.
std::vector<std::vector<double>> distances(const GridWorld& grid) {
  const std::size_t n = grid.states();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, INFINITY));
  for (std::uint32_t s = 0; s < n; ++s)
    for (std::uint32_t k = 0; k < 4; ++k) d[s][grid.move(s, k)] = 1;
  for (std::size_t m = 0; m < n; ++m)
    for (std::size_t s = 0; s < n; ++s)
      for (std::size_t t = 0; t < n; ++t) d[s][t] = std::min(d[s][t], d[s][m] + d[m][t]);
  return d;
}

double tour_by_enumeration(const GridWorld& grid, bool closed) {
  const auto d = distances(grid);
  std::vector<std::vector<std::uint32_t>> places(3);
  for (std::uint32_t s = 0; s < grid.states(); ++s)
    for (std::uint32_t p = 0; p < 3; ++p)
      if (grid.letters()[grid.letter(s)].contains(ltl::Proposition{p}) &&
          (s == grid.initial() || d[0][s] < INFINITY))
        places[p].push_back(s);
  double best = INFINITY;
  std::vector<std::size_t> order{0, 1, 2};
  do {
    for (std::uint32_t x : places[order[0]])
      for (std::uint32_t y : places[order[1]])
        for (std::uint32_t z : places[order[2]])
          best =
              std::min(best, closed ? d[x][y] + d[y][z] + d[z][x] : d[grid.initial()][x] + d[x][y] + d[y][z]);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(LandmarkTour, ShortestWalksAgreeWithEnumeration) {
  ltl::Random random(10);
  int found = 0;
  for (int i = 0; i < scaled(300); ++i) {
    const GridWorld grid = random_grid(random);
    for (bool closed : {false, true}) {
      const double expected = tour_by_enumeration(grid, closed);
      const auto answer = shortest_tour(grid, {"a", "b", "c"}, closed);
      ASSERT_TRUE(answer);
      if (const LandmarkTour* tour = std::get_if<LandmarkTour>(&*answer)) {
        EXPECT_EQ(tour->cost, expected) << "grid " << i << (closed ? " closed" : " open");
        ++found;
      } else {
        EXPECT_TRUE(std::isinf(expected)) << "grid " << i << (closed ? " closed" : " open");
      }
    }
  }
  EXPECT_GT(found, scaled(100));
}

}  // namespace
}  // namespace waymark::plan
