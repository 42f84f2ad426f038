// The cheapest routes against all routes up to a length, judged by definition.
#include "libplan/solve/least_routes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libplan/solve/random_grids.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using waymark::testing::scaled;

struct Found {
  double cost;
  std::vector<std::uint32_t> places;
  friend auto operator<=>(const Found&, const Found&) = default;
};

// Routes of at most so many choices whose word satisfies f for the first time at its end; choices that lead to one
// place count once.
void enumerate(const Mdp& mdp, ltl::Formula f, std::vector<std::uint32_t>& places, std::vector<ltl::Letter>& word,
               double cost, std::size_t length, std::set<Found>& out) {
  if (ltl::holds(ltl::Trace(word), f)) {
    out.insert({cost, places});
    return;
  }
  if (length == 0) return;
  const std::uint32_t at = places.back();
  for (std::uint32_t k = 0; k < mdp.choices(at); ++k) {
    const ModelOutcome& outcome = mdp.outcomes(at, k)[0];
    places.push_back(outcome.target);
    word.push_back(mdp.letters()[outcome.letter]);
    enumerate(mdp, f, places, word, cost + 1, length - 1, out);
    places.pop_back();
    word.pop_back();
  }
}

// Letters of states, so that places make the word; every choice costs 1.
Mdp labelled_places(ltl::Random& random) {
  constexpr std::uint32_t states = 4;
  MdpBuilder builder(testing::vocabulary_ab());
  std::vector<LetterId> letters;
  for (std::uint32_t s = 0; s < states; ++s) {
    ltl::Letter letter;
    for (std::uint32_t p = 0; p < 2; ++p)
      if (random.below(3) == 0) letter.insert(ltl::Proposition{p});
    letters.push_back(builder.letter(letter));
  }
  for (std::uint32_t s = 0; s < states; ++s) {
    builder.add_state();
    const std::size_t choices = 1 + random.below(3);
    for (std::size_t k = 0; k < choices; ++k) {
      builder.add_choice("c");
      const auto to = static_cast<std::uint32_t>(random.below(states));
      builder.add_outcome(to, letters[to]);
    }
  }
  return std::move(builder).build(0, letters[0]);
}

TEST(LeastRoutes, AreTheFirstOfAllRoutes) {
  ltl::Random random(31);
  constexpr std::size_t longest = 8, most = 6;
  int several = 0;
  for (int i = 0; i < scaled(200); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::next(ltl::random_formula(random, arena, {.size = 3 + random.below(7), .atoms = 2}));
    const Mdp mdp = labelled_places(random);
    const auto answer = least_routes(Product(mdp, TaskTable(automata::ltlf_to_dfa(f), mdp.letters())), most);
    ASSERT_TRUE(answer);
    std::vector<std::uint32_t> places{mdp.initial()};
    std::vector<ltl::Letter> word{mdp.letters()[mdp.initial_letter()]};
    std::set<Found> all;
    enumerate(mdp, f, places, word, 0, longest, all);
    const std::string where = ltl::print(f) + " on\n" + testing::show(mdp);
    std::set<std::vector<std::uint32_t>> different;
    std::size_t short_ones = 0;
    double last = 0;
    auto expected = all.begin();
    for (const ChoiceRoute& route : answer->routes) {
      EXPECT_TRUE(different.insert(route.places).second) << where;
      EXPECT_TRUE(ltl::holds(word_of(mdp, route), f)) << where;
      EXPECT_GE(route.cost, last) << where;
      last = route.cost;
      if (route.choices.size() > longest) continue;
      ++short_ones;
      ASSERT_NE(expected, all.end()) << where;
      EXPECT_EQ(route.cost, expected->cost) << where;
      EXPECT_TRUE(all.count({route.cost, route.places})) << where;
      ++expected;
    }
    EXPECT_EQ(short_ones, std::min(most, all.size())) << where;
    several += answer->routes.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(several, scaled(60));
}

TEST(LeastRoutes, BeginWithTheRouteOfTheSearch) {
  ltl::Random random(32);
  for (int i = 0; i < scaled(50); ++i) {
    const GridWorld grid = testing::random_grid(random);
    ltl::Arena arena(grid.letters().vocabulary());
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F a & F b", arena));
    const TaskTable task(dfa, grid.letters());
    const auto one = search(Product(grid, task));
    const auto several = least_routes(Product(grid, task), 5);
    ASSERT_TRUE(one && several);
    ASSERT_EQ(one->route.has_value(), !several->routes.empty());
    if (one->route) {
      EXPECT_EQ(one->route->places, several->routes[0].places) << "grid " << i;
      EXPECT_EQ(several->routes.size(), one->route->choices.empty() ? 1U : 5U);
    }
  }
}

TEST(LeastRoutes, TakeTheCheapestOfChoicesThatLeadToOnePlaceAndOfThoseTheFirst) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  for (const double cost : {3.0, 1.0, 2.0, 1.0}) {
    builder.add_choice("c", cost);
    builder.add_outcome(1, a);
  }
  builder.add_choice("wait", 0.25);
  builder.add_outcome(0, none);
  builder.add_state();
  builder.add_choice("rest");
  builder.add_outcome(1, a);
  const Mdp mdp = std::move(builder).build(0, none);
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F a", arena));
  const auto found = least_routes(Product(mdp, TaskTable(dfa, mdp.letters())), 3);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->routes.size(), 3U);
  for (std::uint32_t waits = 0; waits < 3; ++waits) {
    std::vector<std::uint32_t> choices(waits, 4);
    choices.push_back(1);
    EXPECT_EQ(found->routes[waits].choices, choices);
    EXPECT_EQ(found->routes[waits].cost, 1 + 0.25 * waits);
  }
}

TEST(LeastRoutes, SaysWhenItGaveUp) {
  ltl::Random random(33);
  const GridWorld grid = testing::random_grid(random);
  ltl::Arena arena(grid.letters().vocabulary());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F(a & b)", arena)), grid.letters());
  EXPECT_FALSE(least_routes(Product(grid, task), 5, {.states = 3}));
  const auto none = least_routes(Product(grid, task), 5);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->routes.empty());
}

}  // namespace
}  // namespace waymark::plan
