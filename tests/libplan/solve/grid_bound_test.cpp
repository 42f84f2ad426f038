// The bound against exact distances; routes found under it against those of the same grid written out.
#include "libplan/solve/grid_bound.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/product_search.hpp"
#include "tests/libplan/solve/random_grids.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

constexpr std::uint32_t never = GridBound::never;

// Moves to acceptance from every pair, by state and cell: relaxation until nothing changes.
std::vector<std::vector<std::uint32_t>> moves_to_go(const GridWorld& grid, const TaskTable& task) {
  std::vector<std::vector<std::uint32_t>> out(task.states(), std::vector<std::uint32_t>(grid.states(), never));
  for (std::uint32_t q = 0; q < task.states(); ++q)
    if (task.is_goal(q)) out[q].assign(grid.states(), 0);
  for (bool better = true; better;) {
    better = false;
    for (std::uint32_t q = 0; q < task.states(); ++q)
      for (std::uint32_t s = 0; s < grid.states(); ++s)
        for (std::uint32_t k = 0; k < 4; ++k) {
          const std::uint32_t to = grid.move(s, k), next = task.next(q, grid.letter(to)).target;
          if (next == TaskTable::trap || out[next][to] == never || out[next][to] + 1 >= out[q][s]) continue;
          out[q][s] = out[next][to] + 1;
          better = true;
        }
  }
  return out;
}

TEST(GridBound, IsNeverTooHighAndChangesByOneMoveAtMost) {
  constexpr std::uint64_t seed = 15;
  ltl::Random random(seed);
  std::size_t tight = 0, loose = 0, hopeless = 0;
  for (int i = 0; i < waymark::testing::scaled(400); ++i) {
    const GridWorld grid = testing::random_grid(random);
    ltl::Arena arena(grid.letters().vocabulary());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(9), .atoms = 3});
    const TaskTable task(automata::ltlf_to_dfa(f), grid.letters());
    const auto bound = GridBound::of(grid, task);
    ASSERT_TRUE(bound);
    const auto exact = moves_to_go(grid, task);
    for (std::uint32_t q = 0; q < task.states(); ++q)
      for (std::uint32_t s = 0; s < grid.states(); ++s) {
        if (grid.is_wall(s)) continue;
        const std::uint32_t h = (*bound)(s, q);
        ASSERT_LE(h, exact[q][s]) << ltl::print(f) << ", seed " << seed << ", grid " << i << ", cell " << s;
        ++(h == never ? hopeless : h == exact[q][s] ? tight : loose);
        for (std::uint32_t k = 0; k < 4; ++k) {
          const std::uint32_t to = grid.move(s, k), next = task.next(q, grid.letter(to)).target;
          if (next == TaskTable::trap || task.is_goal(q) || (*bound)(to, next) == never) continue;
          ASSERT_LE(h, (*bound)(to, next) + 1) << ltl::print(f) << ", seed " << seed << ", grid " << i;
        }
      }
  }
  EXPECT_GT(tight, loose / 4);
  EXPECT_GT(loose, tight / 20);
  EXPECT_GT(hopeless, 0U);
}

// Ways to be done with a task, some by letters that show nothing, and most of them left half-way and begun anew.
TEST(GridBound, IsNeverTooHighForTasksThatAreBegunAnew) {
  constexpr std::uint64_t seed = 17;
  ltl::Random random(seed);
  const auto letter = [&] {
    constexpr std::array<const char*, 5> letters{"a", "b", "c", "(!a & !b & !c)", "(!a & !b & !c)"};
    return std::string(letters[random.below(letters.size())]);
  };
  const auto way = [&] {
    std::string steps = letter();
    for (std::size_t more = 1 + random.below(2); more > 0; --more) steps = letter() + " & X (" + steps + ")";
    return "F (" + steps + ")";
  };
  std::size_t finite = 0;
  for (int i = 0; i < waymark::testing::scaled(400); ++i) {
    const GridWorld grid = testing::random_grid(random);
    const std::string text = way() + " | " + way();
    ltl::Arena arena(grid.letters().vocabulary());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse(text, arena)), grid.letters());
    const auto bound = GridBound::of(grid, task);
    ASSERT_TRUE(bound);
    const auto exact = moves_to_go(grid, task);
    for (std::uint32_t q = 0; q < task.states(); ++q)
      for (std::uint32_t s = 0; s < grid.states(); ++s) {
        if (grid.is_wall(s)) continue;
        finite += exact[q][s] < never ? 1 : 0;
        ASSERT_LE((*bound)(s, q), exact[q][s]) << text << ", seed " << seed << ", grid " << i << ", cell " << s;
      }
  }
  EXPECT_GT(finite, 1'000U);
}

// The same choices, written out: what has no bound is searched without one.
Mdp written_out(const GridWorld& grid) {
  MdpBuilder out(grid.letters().vocabulary());
  for (std::uint32_t s = 0; s < grid.states(); ++s) {
    out.add_state();
    for (std::uint32_t k = 0; k < 4; ++k) {
      out.add_choice(grid.action(s, k), grid.cost(s, k));
      const std::uint32_t to = grid.move(s, k);
      out.add_outcome(to, out.letter(grid.letters()[grid.letter(to)]));
    }
  }
  const LetterId first = out.letter(grid.letters()[grid.initial_letter()]);
  return std::move(out).build(grid.initial(), first);
}

GridWorld generated(GridKind kind, std::uint64_t seed) {
  const std::string file = ::testing::TempDir() + "/waymark-" + std::string(name(kind)) + ".json";
  std::ofstream out(file);
  write_case(out, generate_grid({.kind = kind, .width = 150, .height = 150, .landmarks = 3, .seed = seed}));
  out.close();
  return std::get<GridWorld>(read_case(file).model);
}

TEST(GridBound, RoutesAreThoseOfAPlainSearch) {
  std::uint64_t plain = 0, bounded = 0;
  for (const GridKind kind : {GridKind::Rooms, GridKind::Maze, GridKind::Scatter, GridKind::OneWay}) {
    const GridWorld grid = generated(kind, 3);
    const Mdp mdp = written_out(grid);
    ltl::Arena arena(grid.letters().vocabulary());
    for (const char* text :
         {"F (a & F (b & F c))", "F c & F b & F a", "(!a U b) & F (a & X F c)", "F (a & X (!a U c)) & G !zebra",
          "a & F b", "F (c & F (!c & !a & F b))", "F (a & X (!a & X (!a & X !b)))"}) {
      const ltl::Formula f = ltl::parse(text, arena, {.unknown = ltl::Unknown::Add});
      const automata::Dfa dfa = automata::ltlf_to_dfa(f);
      const auto on_grid = search(Product(grid, TaskTable(dfa, grid.letters())));
      const auto on_mdp = search(Product(mdp, TaskTable(dfa, mdp.letters())));
      ASSERT_TRUE(on_grid && on_mdp);
      ASSERT_EQ(on_grid->route.has_value(), on_mdp->route.has_value()) << text;
      if (!on_grid->route) continue;
      EXPECT_EQ(on_grid->route->places, on_mdp->route->places) << text << " on " << name(kind);
      EXPECT_EQ(on_grid->route->choices, on_mdp->route->choices) << text << " on " << name(kind);
      plain += on_mdp->statistics.met;
      bounded += on_grid->statistics.met;
    }
  }
  EXPECT_LT(bounded, plain / 2);
}

// Few walls, each landmark on one cell or on two, one cell with two of them.
GridWorld grid_of_landmarks(ltl::Random& random) {
  const ltl::Vocabulary names({"a", "b", "c"});
  std::vector<GridCell> palette(6);
  palette[1].wall = true;
  for (std::uint32_t p = 0; p < 3; ++p) palette[2 + p].label = {ltl::Proposition{p}};
  palette[5].label = {ltl::Proposition{0}, ltl::Proposition{1}};
  std::vector<std::uint16_t> cells(42);
  for (std::uint16_t& cell : cells) cell = random.below(5) == 0 ? 1 : 0;
  cells[0] = 0;
  for (std::uint16_t kind = 2; kind < 6; ++kind)
    for (std::size_t n = random.below(4) == 0 ? 2 : kind == 5 ? random.below(2) : 1; n > 0; --n)
      cells[1 + random.below(cells.size() - 1)] = kind;
  return GridWorld({.width = 7, .height = 6}, names, palette, cells, 0);
}

// A search of a grid is cut into legs where everything passes one cell; of the same grid written out it is not.
TEST(ProductSearch, LegsMakeTheRouteOfTheWhole) {
  constexpr std::uint64_t seed = 16;
  ltl::Random random(seed);
  std::size_t routes = 0, cut = 0, uncut = 0;
  for (int i = 0; i < waymark::testing::scaled(300); ++i) {
    const GridWorld grid = grid_of_landmarks(random);
    const Mdp mdp = written_out(grid);
    ltl::Arena arena(grid.letters().vocabulary());
    std::vector<ltl::Formula> tasks{ltl::random_formula(random, arena, {.size = 3 + random.below(9), .atoms = 3})};
    for (const char* text : {"F (a & F (b & F c))", "!b U (a & X (!a U (b & X F c)))", "F (a & F (b | c))",
                             "F (a & F (b & X F a))", "F a & F b", "F (a & N F b)"})
      tasks.push_back(ltl::parse(text, arena));
    for (const ltl::Formula f : tasks) {
      const automata::Dfa dfa = automata::ltlf_to_dfa(f);
      const auto on_grid = search(Product(grid, TaskTable(dfa, grid.letters())));
      const auto on_mdp = search(Product(mdp, TaskTable(dfa, mdp.letters())));
      ASSERT_TRUE(on_grid && on_mdp);
      ASSERT_EQ(on_grid->route.has_value(), on_mdp->route.has_value())
          << ltl::print(f) << ", seed " << seed << ", grid " << i;
      ASSERT_LE(on_grid->statistics.met, on_mdp->statistics.met) << ltl::print(f) << ", seed " << seed;
      if (!on_grid->route) continue;
      ++routes;
      ++(on_grid->statistics.met < on_mdp->statistics.met ? cut : uncut);
      ASSERT_EQ(on_grid->route->places, on_mdp->route->places) << ltl::print(f) << ", seed " << seed << ", grid " << i;
      ASSERT_EQ(on_grid->route->choices, on_mdp->route->choices)
          << ltl::print(f) << ", seed " << seed << ", grid " << i;
    }
  }
  EXPECT_GT(cut, routes / 8);
  EXPECT_GT(uncut, routes / 8);
}

}  // namespace
}  // namespace waymark::plan
