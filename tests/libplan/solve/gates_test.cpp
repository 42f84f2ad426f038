// Cells that every route passes: a search that forgets what lies before them finds routes as short as one that does
// not, on all small grids, wherever the cells lie.
#include <gtest/gtest.h>

#include <deque>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/solve/product_search.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

enum Cell : std::uint16_t { Empty, A, B, Wall };

GridWorld grid_of(std::uint32_t width, const std::vector<std::uint16_t>& cells, std::uint32_t start) {
  const auto height = static_cast<std::uint32_t>(cells.size()) / width;
  return GridWorld({.width = width, .height = height}, testing::vocabulary_ab(),
                   {{}, {.label = {ltl::Proposition{0}}}, {.label = {ltl::Proposition{1}}}, {.wall = true}}, cells,
                   start);
}

// The fewest moves, by breadth first over all pairs.
std::optional<std::uint32_t> fewest_moves(const GridWorld& grid, const TaskTable& task) {
  const Product<GridWorld, TaskTable> product(grid, task);
  std::vector<std::uint32_t> depth(std::size_t{grid.states()} * task.states(), UINT32_MAX);
  std::deque<ProductState> queue;
  const auto meet = [&](const ProductState& s, std::uint32_t d) {
    std::uint32_t& known = depth[std::size_t{s.task} * grid.states() + s.place];
    if (known != UINT32_MAX) return;
    known = d;
    queue.push_back(s);
  };
  product.for_each_start([&](const ProductState& s) { meet(s, 0); });
  for (; !queue.empty(); queue.pop_front()) {
    const ProductState from = queue.front();
    const std::uint32_t d = depth[std::size_t{from.task} * grid.states() + from.place];
    if (task.is_goal(from.task)) return d;
    for (std::uint32_t k = 0; k < product.choices(from); ++k)
      product.for_each_successor(from, k, [&](const ProductState& to) { meet(to, d + 1); });
  }
  return std::nullopt;
}

std::string shown(const std::vector<std::uint16_t>& cells, std::uint32_t width, std::uint32_t start) {
  std::string out;
  for (std::size_t i = 0; i < cells.size(); ++i)
    out += std::string(i > 0 && i % width == 0 ? "/" : "") + ".ab#"[cells[i]];
  return out + " from " + std::to_string(start);
}

struct Task {
  ltl::Arena arena{testing::vocabulary_ab()};
  ltl::Formula formula;
  automata::Dfa dfa;
  explicit Task(const char* text) : formula(ltl::parse(text, arena)), dfa(automata::ltlf_to_dfa(formula)) {}
};

// All grids of so many cells, of these kinds; every start that is no wall.
void expect_shortest(std::uint32_t width, std::uint32_t height, std::uint16_t kinds, std::size_t step) {
  for (const char* text : {"F (a & F b)", "F (a & X F (b & X F a))", "!b U (a & X (!a U b))", "F a & F b", "a U b"}) {
    const Task task(text);
    const std::size_t size = std::size_t{width} * height;
    std::size_t grids = 1, routes = 0;
    for (std::size_t i = 0; i < size; ++i) grids *= kinds;
    for (std::size_t n = 0; n < grids; n += step) {
      std::vector<std::uint16_t> cells;
      for (std::size_t rest = n, i = 0; i < size; ++i, rest /= kinds)
        cells.push_back(static_cast<std::uint16_t>(rest % kinds));
      for (std::uint32_t start = 0; start < cells.size(); ++start) {
        if (cells[start] == Wall) continue;
        const GridWorld grid = grid_of(width, cells, start);
        const TaskTable table(task.dfa, grid.letters());
        const auto expected = fewest_moves(grid, table);
        const auto answer = search(Product(grid, table));
        ASSERT_TRUE(answer);
        ASSERT_EQ(answer->route.has_value(), expected.has_value()) << text << " on " << shown(cells, width, start);
        if (!expected) continue;
        ++routes;
        ASSERT_EQ(answer->route->cost, *expected) << text << " on " << shown(cells, width, start);
        ASSERT_TRUE(ltl::holds(word_of(grid, *answer->route), task.formula)) << shown(cells, width, start);
      }
    }
    EXPECT_GT(routes, grids / step / 4) << text;
  }
}

TEST(Gates, LeaveRoutesAsShortInAllRows) { expect_shortest(6, 1, 3, waymark::testing::sanitized ? 7 : 1); }
TEST(Gates, LeaveRoutesAsShortInAllGridsWithWalls) { expect_shortest(3, 2, 4, waymark::testing::sanitized ? 31 : 1); }

// In the first cell of the grid, in the last, and between them: what is met after the gate is counted from there on.
TEST(Gates, NothingIsLookedAtAgainBehindThem) {
  const Task task("F (a & F b)");
  const auto met = [&](const std::vector<std::uint16_t>& cells, std::uint32_t start) {
    const GridWorld grid = grid_of(static_cast<std::uint32_t>(cells.size()), cells, start);
    return search(Product(grid, TaskTable(task.dfa, grid.letters()))).value().statistics.met;
  };
  EXPECT_EQ(met({A, Empty, Empty, Empty, B}, 2), 5U + 4U) << "all cells, east before west, then as far as b";
  EXPECT_EQ(met({B, Empty, Empty, Empty, A}, 2), 4U + 4U) << "all cells but b, then as far as b";
  EXPECT_EQ(met({A, Empty, Empty, A, B}, 2), 4U) << "no gate: the cell in the west is met, too";
  EXPECT_EQ(met({Empty, Empty, Empty, A, B}, 2), 4U - 1U);
}

// A grid that is large enough for A*, the gate in its first cell or its last: on the shortest way, and settled once.
TEST(Gates, LeaveRoutesAsShortInLargeGrids) {
  const Task task("F (a & F b)");
  constexpr std::uint32_t width = 256;
  for (const bool mirrored : {false, true}) {
    std::vector<std::uint16_t> cells(std::size_t{width} * width, Empty);
    const auto place = [&](std::uint32_t x, std::uint32_t y) {
      return mirrored ? width * width - 1 - (y * width + x) : y * width + x;
    };
    cells[place(0, 0)] = A;
    cells[place(30, 40)] = B;
    const GridWorld grid = grid_of(width, cells, place(9, 4));
    const auto answer = search(Product(grid, TaskTable(task.dfa, grid.letters()))).value();
    ASSERT_TRUE(answer.route);
    EXPECT_EQ(answer.route->cost, 13 + 70);
    cells[place(255, 255)] = A;  // two of them: no gate
    const GridWorld two = grid_of(width, cells, place(9, 4));
    const auto other = search(Product(two, TaskTable(task.dfa, two.letters()))).value();
    ASSERT_TRUE(other.route);
    EXPECT_EQ(other.route->cost, 13 + 70);
    EXPECT_LT(answer.statistics.met, other.statistics.met);
  }
}

}  // namespace
}  // namespace waymark::plan
