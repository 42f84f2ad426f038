// Routes and tours against enumeration.
#include "libplan/solve/product_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/landmark_tour.hpp"
#include "tests/libplan/solve/random_grids.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using waymark::testing::scaled;

// The least cost of a route of at most `length` choices whose word satisfies f by definition.
double by_enumeration(const Mdp& mdp, ltl::Formula f, std::uint32_t at, std::vector<ltl::Letter>& word, double cost,
                      std::size_t length) {
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
    const auto answer = search(Product(mdp, TaskTable(dfa, mdp.letters())));
    ASSERT_TRUE(answer);
    std::vector<ltl::Letter> word{mdp.letters()[mdp.initial_letter()]};
    const double expected = by_enumeration(mdp, f, mdp.initial(), word, 0, 8);
    if (!answer->route) {
      EXPECT_TRUE(std::isinf(expected)) << ltl::print(f) << " on\n" << testing::show(mdp);
      continue;
    }
    ++found;
    EXPECT_TRUE(ltl::holds(word_of(mdp, *answer->route), f)) << ltl::print(f) << " on\n" << testing::show(mdp);
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
  EXPECT_THROW(search(Product(mdp, TaskTable(dfa, mdp.letters()))), std::invalid_argument);
}

// Every step is one of the grid's, the costs of all are the tour's, and every landmark is seen.
void expect_walk_of(const LandmarkTour& tour, const GridWorld& grid, bool closed) {
  const ChoiceRoute route = walk(grid, tour);
  EXPECT_NEAR(route.cost, tour.cost, 1e-9);
  ASSERT_EQ(route.places.size(), route.choices.size() + 1);
  std::set<std::string> seen;
  const auto see = [&](LetterId letter) {
    for (const std::string name : {"a", "b", "c"})
      if (const auto p = grid.letters().vocabulary().find(name); p && grid.letters()[letter].contains(*p))
        seen.insert(name);
  };
  if (!closed) see(grid.initial_letter());
  double cost = 0;
  for (std::size_t i = 0; i < route.choices.size(); ++i) {
    ASSERT_LT(route.choices[i], grid.choices(route.places[i]));
    cost += grid.cost(route.places[i], route.choices[i]);
    grid.for_each_outcome(route.places[i], route.choices[i], [&](std::uint32_t t, LetterId letter, double) {
      EXPECT_EQ(t, route.places[i + 1]);
      see(letter);
    });
  }
  EXPECT_NEAR(cost, tour.cost, 1e-9);
  EXPECT_EQ(seen.size(), 3U);
  EXPECT_EQ(route.places.front() == route.places.back() && closed, closed);
}

TEST(LandmarkTour, ShortestWalksAgreeWithEnumeration) {
  ltl::Random random(10);
  int found = 0;
  for (int i = 0; i < scaled(300); ++i) {
    const GridWorld grid = testing::random_grid(random, i % 3 == 0);
    for (bool closed : {false, true}) {
      const double expected = testing::tour_by_enumeration(grid, closed);
      const auto answer = shortest_tour(grid, {"a", "b", "c"}, closed);
      ASSERT_TRUE(answer);
      if (const LandmarkTour* tour = std::get_if<LandmarkTour>(&*answer)) {
        EXPECT_EQ(tour->cost, expected) << "grid " << i << (closed ? " closed" : " open");
        expect_walk_of(*tour, grid, closed);
        ++found;
      } else {
        EXPECT_TRUE(std::isinf(expected)) << "grid " << i << (closed ? " closed" : " open");
      }
    }
  }
  EXPECT_GT(found, scaled(100));
}

TEST(LandmarkTour, NamesWhatIsNeverSeen) {
  ltl::Vocabulary names({"a", "b"});
  const GridWorld grid({.width = 2, .height = 1}, names, {{}, {.label = {ltl::Proposition{1}}}}, {0, 1}, 0);
  const auto reason = [&](const std::vector<std::string>& landmarks) {
    return std::get<NoLandmarkTour>(shortest_tour(grid, landmarks, false).value()).reason;
  };
  EXPECT_EQ(reason({"a", "b", "c"}), "never seen from the start: a c");
  EXPECT_EQ(reason({"c", "b"}), "never seen from the start: c");
  EXPECT_TRUE(std::holds_alternative<LandmarkTour>(shortest_tour(grid, {"b"}, false).value()));
}

// A landmark that stands on one of two moves into a place is at none of the places.
TEST(LandmarkTour, RefusesLandmarksOfSomeMovesIntoAPlace) {
  for (const int moves : {1, 2, 3}) {  // one, two by the landmark, or one of the two
    MdpBuilder builder(ltl::Vocabulary({"a"}));
    const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
    builder.add_state();
    builder.add_choice("by the landmark");
    builder.add_outcome(1, a);
    if (moves > 1) {
      builder.add_choice("round it");
      builder.add_outcome(1, moves == 2 ? a : none);
    }
    builder.add_state();
    builder.add_choice("back");
    builder.add_outcome(0, none);
    const Mdp mdp = std::move(builder).build(0, none);
    if (moves < 3) {
      EXPECT_EQ(std::get<LandmarkTour>(shortest_tour(mdp, {"a"}, false).value()).cost, 1);
    } else {
      EXPECT_THROW(shortest_tour(mdp, {"a"}, false), std::invalid_argument);
    }
  }
}

TEST(LandmarkTour, OfTheStartAloneCostsNothing) {
  ltl::Vocabulary names({"a"});
  const GridWorld grid({.width = 2, .height = 1}, names, {{}, {.label = {ltl::Proposition{0}}}}, {1, 0}, 0);
  EXPECT_EQ(std::get<LandmarkTour>(shortest_tour(grid, {"a"}, false).value()).cost, 0);
}

// A ring of places. The first letter of all is a's, which is seen on one step, as b is on another.
TEST(LandmarkTour, OfARingGoesRoundIt) {
  for (const bool only_at_the_start : {false, true}) {
    MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
    const LetterId a = builder.letter({ltl::Proposition{0}}), none = builder.letter({}),
                   b = builder.letter({ltl::Proposition{1}});
    for (std::uint32_t s = 0; s < 4; ++s) {
      builder.add_state();
      builder.add_choice("on", 1 + s);
      builder.add_outcome((s + 1) % 4, s == 1 && !only_at_the_start ? a : s == 2 ? b : none);
    }
    const Mdp mdp = std::move(builder).build(0, only_at_the_start ? a : none);
    const auto cost = [&](const std::vector<std::string>& landmarks, bool closed) {
      const auto found = shortest_tour(mdp, landmarks, closed).value();
      const auto* tour = std::get_if<LandmarkTour>(&found);
      return tour == nullptr ? INFINITY : tour->cost;
    };
    EXPECT_EQ(cost({"a"}, false), only_at_the_start ? 0 : 3);
    EXPECT_EQ(cost({"a"}, true), only_at_the_start ? INFINITY : 10);
    EXPECT_EQ(cost({"b"}, true), 10);
    EXPECT_EQ(cost({"a", "b"}, false), 6);
    EXPECT_EQ(cost({"b", "a"}, true), only_at_the_start ? INFINITY : 10);
  }
}

// All landmarks are at the start, and no step leads to any.
TEST(LandmarkTour, OfWhatIsOnlySeenFirstCostsNothing) {
  MdpBuilder builder(ltl::Vocabulary({"a"}));
  const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("stay");
  builder.add_outcome(0, none);
  const Mdp mdp = std::move(builder).build(0, a);
  const auto found = shortest_tour(mdp, {"a"}, false).value();
  ASSERT_TRUE(std::holds_alternative<LandmarkTour>(found));
  EXPECT_EQ(std::get<LandmarkTour>(found).cost, 0);
  EXPECT_EQ(std::get<LandmarkTour>(found).stops, std::vector<std::uint32_t>{0});
}

TEST(LandmarkTour, StopsWhenAsked) {
  ltl::Random random(10);
  const GridWorld grid = testing::random_grid(random);
  std::stop_source source;
  source.request_stop();
  for (bool closed : {false, true}) EXPECT_EQ(shortest_tour(grid, {"a"}, closed, source.get_token()), std::nullopt);
}

// A row of cells with landmarks; `rows` of them, the others empty.
GridWorld row_with(std::vector<std::uint16_t> cells, std::uint32_t start, std::uint32_t rows = 1) {
  const auto width = static_cast<std::uint32_t>(cells.size());
  cells.resize(std::size_t{width} * rows, 0);
  return GridWorld({.width = width, .height = rows}, testing::vocabulary_ab(),
                   {{}, {.label = {ltl::Proposition{0}}}, {.label = {ltl::Proposition{1}}}}, cells, start);
}

SearchAnswer searched(const GridWorld& grid, const char* formula) {
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(formula, arena));
  return search(Product(grid, TaskTable(dfa, grid.letters()))).value();
}

TEST(ProductSearch, NothingIsLookedAtAgainAfterALandmarkThatAllRoutesPass) {
  const SearchAnswer answer = searched(row_with({2, 0, 0, 0, 0, 0, 1}, 3), "F (a & F b)");
  EXPECT_EQ(answer.route.value().cost, 9);
  EXPECT_EQ(answer.statistics.met, 12U) << "the start, two to either side, `a`, and six on the way back to `b`";
  EXPECT_EQ(answer.statistics.edges, 40U) << "four of each of them but one in the west and `b`";
}

TEST(ProductSearch, StopsAtItsLimits) {
  const GridWorld grid = row_with({0, 0, 0, 1, 0}, 0);
  ltl::Arena arena(testing::vocabulary_ab());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F (a & F !a)", arena)), grid.letters());
  const std::size_t met = search(Product(grid, task)).value().statistics.met;
  EXPECT_TRUE(search(Product(grid, task), {.states = met}));
  EXPECT_FALSE(search(Product(grid, task), {.states = 2}));
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(search(Product(grid, task), {.states = SIZE_MAX, .stop = source.get_token()}));
}

// `a` alone is in one cell, the first, but is seen with `b` in another one, too: no route has to pass the first.
TEST(ProductSearch, ACellIsNoGateWhereAnotherLetterServesAsWell) {
  const ltl::Letter a{ltl::Proposition{0}}, b{ltl::Proposition{1}}, both{ltl::Proposition{0}, ltl::Proposition{1}};
  const GridWorld grid({.width = 9, .height = 1}, testing::vocabulary_ab(),
                       {{.label = a}, {}, {.label = both}, {.label = b}}, {0, 1, 1, 1, 1, 1, 2, 1, 3}, 2);
  ltl::Arena arena(testing::vocabulary_ab());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F (a & X F (!a & b))", arena)), grid.letters());
  EXPECT_EQ(search(Product(grid, task)).value().route.value().cost, 6);
}

TEST(ProductSearch, ALargeGridWhoseStartIsWalledInHasNoRoute) {
  constexpr std::uint32_t width = 40;
  std::vector<std::uint16_t> cells(std::size_t{width} * 1'700, 0);
  cells.back() = 1;
  for (std::uint32_t i = 0; i < 4; ++i) cells[width * 3 + i] = cells[width * i + 3] = 2;
  const GridWorld grid({.width = width, .height = static_cast<std::uint32_t>(cells.size()) / width},
                       testing::vocabulary_ab(), {{}, {.label = {ltl::Proposition{0}}}, {.wall = true}}, cells, 0);
  ltl::Arena arena(testing::vocabulary_ab());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a", arena)), grid.letters());
  const SearchAnswer answer = search(Product(grid, task)).value();
  EXPECT_FALSE(answer.route);
  EXPECT_EQ(answer.statistics.met, 9U + 9U) << "by both searches";
}

// Of two costs, so that the search is not one in layers: all pairs are met before the goal is settled.
TEST(ProductSearch, BestFirstStopsAtItsLimits) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({}), goal = builder.letter({ltl::Proposition{0}});
  for (std::uint32_t s = 0; s < 8; ++s) {
    builder.add_state();
    builder.add_choice("on", 1 + s % 2);
    builder.add_outcome(s < 7 ? s + 1 : s, s == 6 ? goal : none);
  }
  const Mdp mdp = std::move(builder).build(0, none);
  ltl::Arena arena(testing::vocabulary_ab());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a", arena)), mdp.letters());
  const auto found = search(Product(mdp, task), {.states = 8});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->statistics.met, 8U);
  EXPECT_EQ(found->route.value().cost, 10);
  EXPECT_FALSE(search(Product(mdp, task), {.states = 7}));
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(search(Product(mdp, task), {.states = SIZE_MAX, .stop = source.get_token()}));
}

TEST(ProductSearch, CountsBothSearchesOfALargeGrid) {
  std::vector<std::uint16_t> cells(256, 0);
  cells[200] = 1;
  const SearchAnswer answer = searched(row_with(cells, 40, 256), "F a");
  EXPECT_EQ(answer.route.value().cost, 160);
  EXPECT_EQ(answer.statistics.met, 160U + 161U) << "the straight way without its end, then the whole of it";
  EXPECT_EQ(answer.statistics.edges, 4U * (160U + 160U));
}

}  // namespace
}  // namespace waymark::plan
