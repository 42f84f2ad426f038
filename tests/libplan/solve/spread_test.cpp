// Searches by several threads find what one thread finds: on random graphs, and on products large enough to be shared.
#include "libplan/solve/spread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/end_components.hpp"
#include "libplan/solve/kept_bounds.hpp"
#include "libplan/solve/reachability.hpp"
#include "libplan/solve/strategy.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using GridProduct = ProductMdp<GridWorld>;

std::uint32_t number_below(std::size_t size, ltl::Random& random) {
  return static_cast<std::uint32_t>(random.below(size));
}

TEST(StateSet, IsASetOfNumbers) {
  ltl::Random random(5);
  for (const std::size_t size : {0U, 1U, 63U, 64U, 65U, 200U}) {
    StateSet set(size), all(size, true), none(size);
    std::vector<bool> as_it_should_be(size, false);
    for (std::uint32_t round = 0; round < 4 * size; ++round) {
      const auto i = number_below(size, random);
      const bool was = as_it_should_be[i];
      const std::size_t how = random.below(4);
      as_it_should_be[i] = how % 2 == 0;
      if (how == 0) set.insert(i);
      if (how == 1) set.erase(i);
      if (how == 2) {
        EXPECT_EQ(set.join(i), !was);
      } else if (how == 3) {
        EXPECT_EQ(set.leave(i), was);
      }
    }
    for (std::uint32_t i = 0; i < size; ++i) EXPECT_EQ(set[i], as_it_should_be[i]) << i << " of " << size;
    StateSet rest = all;
    rest -= set;
    for (std::uint32_t i = 0; i < size; ++i) {
      EXPECT_NE(rest[i], set[i]);
      EXPECT_EQ(rest == all, set == none);
      all.erase(i);
    }
    EXPECT_EQ(all, none) << "bits behind the last one";
    EXPECT_EQ(all == StateSet(size + 1), false);
  }
}

TEST(Choices, KeepThoseOfBeforeWhenTheyNeedMoreThanAByte) {
  Choices choices(4);
  choices.set(0, 7);
  choices.set(1, 254);
  choices.set(3, 300);
  EXPECT_EQ(choices[0], 7U);
  EXPECT_EQ(choices[1], 254U);
  EXPECT_EQ(choices[2], Choices::none);
  EXPECT_EQ(choices[3], 300U);
}

// Each number is expanded once, and what is met is what can be reached, on any number of threads.
TEST(SearchTogether, MeetsWhatOneThreadMeets) {
  ltl::Random random(6);
  for (int round = 0; round < waymark::testing::scaled(60); ++round) {
    const std::uint32_t size = 1 + number_below(3'000, random), first = 1 + number_below(3, random);
    std::vector<std::vector<std::uint32_t>> edges(size);
    for (std::uint32_t e = size + number_below(size, random) + number_below(size, random); e > 0; --e)
      edges[random.below(size)].push_back(number_below(size, random));
    StateSet reached(size);
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < std::min(first, size); ++i) open.push_back(i), reached.insert(i);
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      for (const std::uint32_t t : edges[i])
        if (reached.join(t)) open.push_back(t);
    }
    for (const std::size_t threads : {1U, 2U, 5U}) {
      StateSet met(size);
      std::vector<std::atomic<int>> expanded(size);
      const auto begin = [&](std::size_t range, const auto& put) {
        if (range < size && met.join(static_cast<std::uint32_t>(range))) put(static_cast<std::uint32_t>(range));
      };
      const auto expand = [&](std::uint32_t i, const auto& put, std::size_t thread) {
        EXPECT_LT(thread, threads);
        ++expanded[i];
        for (const std::uint32_t t : edges[i])
          if (met.join(t)) put(t);
        return true;
      };
      EXPECT_TRUE(search_together<std::uint32_t>(first, threads, begin, expand));
      ASSERT_EQ(met, reached) << "round " << round << " threads " << threads;
      for (std::uint32_t i = 0; i < size; ++i) ASSERT_EQ(expanded[i], reached[i] ? 1 : 0) << i;
    }
  }
}

TEST(SearchTogether, EndsForAllThreadsWhenOneGivesUp) {
  for (const std::size_t threads : {1U, 2U, 4U})
    for (const bool throws : {false, true}) {
      std::atomic<std::uint32_t> next{0};
      const auto begin = [&](std::size_t, const auto& put) { put(next++); };
      const auto expand = [&](std::uint32_t i, const auto& put, std::size_t) {
        for (int twice = 0; twice < 2; ++twice) put(next++);  // without end
        if (i >= 2'000 && throws) throw std::runtime_error("enough");
        return i < 2'000;
      };
      if (throws)
        EXPECT_THROW(search_together<std::uint32_t>(1, threads, begin, expand), std::runtime_error);
      else
        EXPECT_FALSE(search_together<std::uint32_t>(1, threads, begin, expand));
    }
}

// Walls, one-way cells, hazards x, landmarks a and b, and slips to both sides.
GridWorld large_grid(std::uint32_t side, ltl::Random& random) {
  const ltl::Vocabulary names({"a", "b", "x"});
  std::vector<GridCell> palette(8);
  palette[1].wall = true;
  for (std::uint32_t p = 0; p < 3; ++p) palette[2 + p].label = {ltl::Proposition{p}};
  for (std::size_t way = 0; way < 3; ++way) palette[5 + way].one_way = all_compass[way];
  std::vector<std::uint16_t> cells(std::size_t{side} * side, 0);
  for (std::uint16_t& cell : cells)
    if (const std::size_t r = random.below(40); r < 10) cell = static_cast<std::uint16_t>(r < 3 ? 1 : 2 + r % 6);
  cells[0] = 0;
  const SlipChances slip{.forward = 0.8, .left = 0.1, .right = 0.1};
  return GridWorld({.width = side, .height = side, .motion = {slip, slip, slip, slip}}, names, palette, cells, 0);
}

// visit(product, the same product on four threads, what it is)
template <class Visit>
void for_each_large_product(const Visit& visit) {
  ltl::Random random(7);
  const GridWorld grid = large_grid(260, random);
  for (const char* text : {"F (a & F b)", "!x U (a & (!x U b))", "F a & G !x"}) {
    ltl::Arena arena(grid.letters().vocabulary());
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(text, arena));
    const TaskTable task(dfa, grid.letters());
    const auto one = GridProduct::explore(grid, task), four = GridProduct::explore(grid, task, {}, 4);
    ASSERT_TRUE(one && four) << text;
    visit(*one, *four, std::string(text));
  }
}

TEST(Spread, LargeProductsAreTheSameOnAnyNumberOfThreads) {
  std::size_t shared = 0;
  for_each_large_product([&](const GridProduct& one, const GridProduct& four, const std::string& what) {
    EXPECT_EQ(one.states(), four.states()) << what;
    EXPECT_EQ(one.edges(), four.edges()) << what;
    EXPECT_EQ(one.starts(), four.starts()) << what;
    EXPECT_EQ(one.blocks(), four.blocks()) << what;
    for (std::uint32_t i = 0; i < one.states(); i += 97) EXPECT_EQ(one.state(i).place, four.state(i).place) << what;
    shared += StateRanges{one.states()}.threads(4) > 1 ? 1 : 0;
  });
  EXPECT_EQ(shared, 3U) << "products are large enough for several threads";
}

TEST(Spread, SetsAreTheSameOnAnyNumberOfThreads) {
  std::size_t unsure = 0;
  for_each_large_product([&](const GridProduct& product, const GridProduct&, const std::string& what) {
    StateSet goals(product.states()), safe(product.states(), true);
    product.for_each_state([&](const auto& s) { goals.set(s.index, product.is_goal(s)); });
    const Reaching alone = reaching(product, goals), together = reaching(product, goals, 4);
    EXPECT_EQ(alone.some, together.some) << what;
    EXPECT_EQ(alone.sure, together.sure) << what;
    unsure += alone.some == alone.sure ? 0 : 1;
    StateSet safe_alone = alone.some, safe_together = alone.some;
    keep_safe(product, goals, safe_alone);
    keep_safe(product, goals, safe_together, 4);
    EXPECT_EQ(safe_alone, safe_together) << what;
    EXPECT_EQ(entries(product, alone.some, product.starts()), entries(product, alone.some, product.starts(), 4));
    if (what.front() != '!') return;  // one of them: many rounds
    const auto northwards = [](const auto&, std::uint32_t k) { return k != 2; };
    const EndComponents a = end_components(product, safe, northwards), b = end_components(product, safe, northwards, 4);
    EXPECT_EQ(a.of, b.of) << what;
    EXPECT_EQ(a.count, b.count) << what;
  });
  EXPECT_GT(unsure, 0U);
}

}  // namespace
}  // namespace waymark::plan
