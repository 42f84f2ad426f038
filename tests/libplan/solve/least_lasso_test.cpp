// Least-cost lassos against walks of every length, against lassos tried one by one, and against tours.
#include "libplan/solve/least_lasso.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/product/buchi_product.hpp"
#include "tests/libplan/solve/random_grids.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using waymark::testing::scaled;
using Value = std::pair<double, double>;  // what counts first, what counts second

// Everything about a small marked graph by walks of every length.
class ByLength {
 public:
  explicit ByLength(const MarkedGraph& graph) : graph_(graph), reach_(graph.vertices(), INFINITY) {
    for (std::uint32_t v : graph.starts) reach_[v] = 0;
    for (std::uint32_t round = 0; round < graph.vertices(); ++round)
      for (const MarkedEdge& e : graph.edges) reach_[e.to] = std::min(reach_[e.to], reach_[e.from] + e.cost);
  }

  Value least(LassoOrder order) const {
    Value best{INFINITY, INFINITY};
    for (std::uint32_t v = 0; v < graph_.vertices(); ++v) {
      const double cycle = order == LassoOrder::Mean ? mean(v) : round(v);
      if (std::isinf(cycle) || std::isinf(reach_[v])) continue;
      best = std::min(best, order == LassoOrder::Prefix ? Value{reach_[v], cycle} : Value{cycle, reach_[v]});
    }
    return best;
  }

 private:
  // A walk from v to v that meets every mark.
  double round(std::uint32_t v) const {
    const auto full = static_cast<std::uint32_t>(graph_.all().bits());
    const std::uint32_t sets = graph_.sets;
    std::vector<double> now(std::size_t{graph_.vertices()} << sets, INFINITY);
    now[v << sets] = 0;
    double best = INFINITY;
    for (std::size_t length = 0; length < now.size(); ++length) {
      std::vector<double> next(now.size(), INFINITY);
      for (const MarkedEdge& e : graph_.edges)
        for (std::uint32_t met = 0; met <= full; ++met) {
          double& to = next[(e.to << sets) | met | static_cast<std::uint32_t>(e.marks.bits())];
          to = std::min(to, now[(e.from << sets) | met] + e.cost);
        }
      now = next;
      best = std::min(best, now[(v << sets) | full]);
    }
    return best;
  }

  // The least cost a round of a walk from (v, met) back to it, over all sets met: cost by number of rounds.
  double mean(std::uint32_t v) const {
    const std::uint32_t full = static_cast<std::uint32_t>(graph_.all().bits()), sets = graph_.sets;
    const std::size_t size = std::size_t{graph_.vertices()} << sets;
    double best = INFINITY;
    for (std::uint32_t begin = 0; begin <= (full >> 1U); ++begin) {
      std::vector<std::vector<double>> now(size, std::vector<double>(size + 1, INFINITY));
      now[(v << sets) | begin][0] = 0;
      for (std::size_t length = 0; length < size; ++length) {
        std::vector<std::vector<double>> next(size, std::vector<double>(size + 1, INFINITY));
        for (const MarkedEdge& e : graph_.edges)
          for (std::uint32_t met = 0; met == 0 || met < full; ++met) {
            const std::uint32_t all = met | static_cast<std::uint32_t>(e.marks.bits());
            const bool completes = all == full;
            for (std::size_t rounds = 0; rounds < size; ++rounds) {
              double& to = next[(e.to << sets) | (completes ? 0 : all)][rounds + (completes ? 1 : 0)];
              to = std::min(to, now[(e.from << sets) | met][rounds] + e.cost);
            }
          }
        now = next;
        for (std::size_t rounds = 1; rounds <= size; ++rounds)
          best = std::min(best, now[(v << sets) | begin][rounds] / static_cast<double>(rounds));
      }
    }
    return best;
  }

  const MarkedGraph& graph_;
  std::vector<double> reach_;
};

// Is there a lasso of the model with so short a prefix and a cycle that satisfies f, by definition?
bool some_lasso(const Mdp& mdp, ltl::Formula f, std::size_t length) {
  std::vector<std::uint32_t> places{mdp.initial()};
  std::vector<ltl::Letter> word{mdp.letters()[mdp.initial_letter()]};
  const auto closes = [&] {
    for (std::size_t back = 0; back + 1 < places.size(); ++back)
      if (places[back] == places.back() &&
          ltl::holds(ltl::Lasso({word.begin(), word.begin() + static_cast<std::ptrdiff_t>(back) + 1},
                                {word.begin() + static_cast<std::ptrdiff_t>(back) + 1, word.end()}),
                     f))
        return true;
    return false;
  };
  const auto walk = [&](const auto& self, std::size_t left) -> bool {
    if (closes()) return true;
    if (left == 0) return false;
    for (std::uint32_t k = 0; k < mdp.choices(places.back()); ++k) {
      const ModelOutcome& outcome = mdp.outcomes(places.back(), k)[0];
      places.push_back(outcome.target);
      word.push_back(mdp.letters()[outcome.letter]);
      const bool found = self(self, left - 1);
      places.pop_back();
      word.pop_back();
      if (found) return true;
    }
    return false;
  };
  return walk(walk, length);
}

Value value(const LassoRoute& route, LassoOrder order) {
  switch (order) {
    case LassoOrder::Prefix: return {route.prefix.cost, route.cycle.cost};
    case LassoOrder::Cycle: return {route.cycle.cost, route.prefix.cost};
    case LassoOrder::Mean: break;
  }
  return {route.mean(), route.prefix.cost};
}

TEST(LeastLasso, AgreesWithWalksOfEveryLength) {
  ltl::Random random(21);
  int found = 0, none = 0;
  for (int i = 0; i < scaled(400); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(7), .atoms = 2});
    const Mdp mdp = testing::random_model(
        random, {.states = 3, .most_choices = 3, .deterministic = true, .unit_costs = random.below(2) == 0});
    const automata::Automaton automaton = automata::ltl_to_tgba(f);
    automata::Budget budget;
    const BuchiProduct product = compose(mdp, automaton, budget);
    if ((product.states.size() << product.graph.sets) > 24) continue;
    for (LassoOrder order : {LassoOrder::Prefix, LassoOrder::Cycle, LassoOrder::Mean}) {
      const auto answer = least_lasso(mdp, automaton, order);
      ASSERT_TRUE(answer);
      const Value expected = ByLength(product.graph).least(order);
      const std::string where = ltl::print(f) + " by " + std::string(name(order)) + " on\n" + testing::show(mdp);
      if (!answer->route) {
        EXPECT_TRUE(std::isinf(expected.first)) << where;
        EXPECT_FALSE(some_lasso(mdp, f, 5)) << where;
        ++none;
        continue;
      }
      ++found;
      EXPECT_EQ(value(*answer->route, order), expected) << where;
      EXPECT_NO_THROW(certify(*answer->route, mdp, f)) << where;
    }
  }
  EXPECT_GT(found, scaled(300));
  EXPECT_GT(none, scaled(50));
}

TEST(LeastLasso, FewestStepsOfAPatrolAreThoseOfTheTour) {
  ltl::Random random(22);
  int found = 0;
  for (int i = 0; i < scaled(100); ++i) {
    const GridWorld grid = testing::random_grid(random);
    ltl::Arena arena(grid.letters().vocabulary());
    const ltl::Formula f = ltl::parse("G F a & G F b & G F c", arena);
    const automata::Automaton automaton = automata::ltl_to_tgba(f);
    const auto answer = least_lasso(grid, automaton, LassoOrder::Cycle);
    ASSERT_TRUE(answer);
    const double expected = testing::tour_by_enumeration(grid, true);
    ASSERT_EQ(answer->route.has_value(), std::isfinite(expected)) << "grid " << i;
    if (!answer->route) continue;
    ++found;
    EXPECT_EQ(answer->route->cycle.cost, expected) << "grid " << i;
    const CertifiedLasso certified = certify(*answer->route, grid, f);
    const auto mean = least_lasso(grid, automaton, LassoOrder::Mean);
    EXPECT_LE(mean->route->mean(), certified.route().cycle.cost) << "grid " << i;
  }
  EXPECT_GT(found, scaled(25));
}

// One circle past a twice costs less a visit than the shorter one past it once.
TEST(LeastLasso, MeanCountsVisits) {
  MdpBuilder builder(testing::vocabulary_ab());
  ltl::Letter a;
  a.insert(ltl::Proposition{0});
  const LetterId seen = builder.letter(a), plain = builder.letter({});
  builder.add_state();
  builder.add_choice("once", 5);
  builder.add_outcome(0, seen);
  builder.add_choice("twice", 4);
  builder.add_outcome(1, seen);
  builder.add_state();
  builder.add_choice("back", 4);
  builder.add_outcome(0, seen);
  const Mdp mdp = std::move(builder).build(0, plain);
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Automaton automaton = automata::ltl_to_tgba(ltl::parse("G F a", arena));
  const auto cycle = least_lasso(mdp, automaton, LassoOrder::Cycle);
  EXPECT_EQ(cycle->route->cycle.cost, 5);
  const auto mean = least_lasso(mdp, automaton, LassoOrder::Mean);
  EXPECT_EQ(mean->route->cycle.cost, 8);
  EXPECT_EQ(mean->route->rounds, 2U);
  EXPECT_EQ(mean->route->mean(), 4);
}

// Steps {from, to, cost, is a seen on it}; 0 is where a run begins.
struct StepSeen {
  std::uint32_t from, to;
  double cost;
  bool seen;
};
Mdp steps_of(const std::vector<StepSeen>& steps, double unit = 1) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId plain = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
  std::uint32_t states = 0;
  for (const StepSeen& step : steps) states = std::max({states, step.from + 1, step.to + 1});
  for (std::uint32_t s = 0; s < states; ++s) {
    builder.add_state();
    for (const StepSeen& step : steps) {
      if (step.from != s) continue;
      builder.add_choice("to " + std::to_string(step.to), step.cost * unit);
      builder.add_outcome(step.to, step.seen ? a : plain);
    }
  }
  return std::move(builder).build(0, plain);
}

// Two circles past a cost the same. The last step of both costs nothing, the one that is met later passes the start.
TEST(LeastLasso, OfCyclesThatEndWithStepsForNothingIsTheNearest) {
  const Mdp mdp = steps_of({{0, 1, 9, false},
                            {0, 2, 0, false},
                            {1, 3, 0, false},
                            {2, 4, 1, false},
                            {3, 1, 2, true},
                            {3, 2, 1, true},
                            {4, 3, 0, false}});
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Automaton automaton = automata::ltl_to_tgba(ltl::parse("G F a", arena));
  const auto found = least_lasso(mdp, automaton, LassoOrder::Cycle);
  automata::Budget budget;
  EXPECT_EQ(ByLength(compose(mdp, automaton, budget).graph).least(LassoOrder::Cycle), (Value{2, 0}));
  EXPECT_EQ(value(*found->route, LassoOrder::Cycle), (Value{2, 0}));
}

// The nearest place of the best circle has a step back to itself for nothing, on which a is not seen.
TEST(LeastLasso, OfTheLeastMeanGoesRoundAndDoesNotWait) {
  const Mdp mdp = steps_of(
      {{0, 0, 50, true}, {0, 1, 9, false}, {0, 2, 1, false}, {1, 2, 1, true}, {2, 1, 1, false}, {2, 2, 0, false}});
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Automaton automaton = automata::ltl_to_tgba(ltl::parse("G F a", arena));
  const auto found = least_lasso(mdp, automaton, LassoOrder::Mean);
  automata::Budget budget;
  EXPECT_EQ(ByLength(compose(mdp, automaton, budget).graph).least(LassoOrder::Mean), (Value{2, 1}));
  EXPECT_EQ(value(*found->route, LassoOrder::Mean), (Value{2, 1}));
}

// Costs in a unit that is a power of two are rounded nowhere: the same route, and its costs in that unit.
TEST(LeastLasso, IsTheSameInAnotherUnitOfCost) {
  ltl::Random random(24);
  const double unit = std::ldexp(1, -60);
  int found = 0;
  for (int i = 0; i < scaled(100); ++i) {
    std::vector<StepSeen> steps;
    for (std::uint32_t s = 0; s < 5; ++s)
      for (int k = 0; k < 3; ++k)
        steps.push_back({s, static_cast<std::uint32_t>(random.below(5)), static_cast<double>(1 + random.below(9)),
                         random.below(3) == 0});
    ltl::Arena arena(testing::vocabulary_ab());
    const automata::Automaton automaton = automata::ltl_to_tgba(ltl::parse("G F a", arena));
    const Mdp mdp = steps_of(steps), small = steps_of(steps, unit);
    for (const LassoOrder order : {LassoOrder::Prefix, LassoOrder::Cycle, LassoOrder::Mean}) {
      const auto one = least_lasso(mdp, automaton, order), other = least_lasso(small, automaton, order);
      ASSERT_EQ(one->route.has_value(), other->route.has_value());
      if (!one->route) continue;
      ++found;
      const Value in_unit = value(*other->route, order);
      EXPECT_EQ(value(*one->route, order), (Value{in_unit.first / unit, in_unit.second / unit}))
          << name(order) << " on\n"
          << testing::show(mdp);
    }
  }
  EXPECT_GT(found, scaled(150));
}

TEST(LeastLasso, SaysByWhatItWasChecked) {
  const Mdp mdp = steps_of({{0, 0, 1, true}});
  ltl::Arena arena(testing::vocabulary_ab());
  const ltl::Formula f = ltl::parse("G F a", arena);
  const automata::Automaton automaton = automata::ltl_to_tgba(f);
  const LassoRoute route = *least_lasso(mdp, automaton, LassoOrder::Prefix)->route;
  EXPECT_TRUE(certify(route, mdp, f).by_definition());
  EXPECT_FALSE(certify(route, mdp, automaton).by_definition());
}

TEST(LeastLasso, GivesUpAndRefuses) {
  ltl::Random random(23);
  const GridWorld grid = testing::random_grid(random);
  ltl::Arena arena(grid.letters().vocabulary());
  const automata::Automaton automaton = automata::ltl_to_tgba(ltl::parse("G F a & G F b", arena));
  EXPECT_FALSE(least_lasso(grid, automaton, LassoOrder::Cycle, {.states = 3}));
  Mdp mdp = testing::random_model(random, {.states = 5});
  while (mdp.is_deterministic()) mdp = testing::random_model(random, {.states = 5});
  EXPECT_THROW(least_lasso(mdp, automaton, LassoOrder::Cycle), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
