// The greatest expected cost against all strategies of small models, each solved as linear equations.
#include "libplan/solve/greatest_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stop_token>
#include <utility>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/solve/case_task.hpp"
#include "tests/libplan/model/models.hpp"

namespace waymark::plan {
namespace {

// Every memoryless strategy of the model itself; a run stops behind the first letter that has b.
class AllStrategies {
 public:
  explicit AllStrategies(const Mdp& mdp) : mdp_(mdp), choice_(mdp.states(), 0) {}

  double greatest() {
    double out = 0;
    do out = std::max(out, cost());
    while (next());
    return out;
  }

 private:
  bool has_b(LetterId letter) const {
    const auto b = mdp_.letters().vocabulary().find("b");
    return b && mdp_.letters()[letter].contains(*b);
  }
  bool next() {
    for (std::uint32_t s = 0; s < mdp_.states(); ++s) {
      if (++choice_[s] < mdp_.choices(s)) return true;
      choice_[s] = 0;
    }
    return false;
  }
  double cost() const {
    if (has_b(mdp_.initial_letter())) return 0;
    const auto n = static_cast<std::uint32_t>(mdp_.states());
    std::vector<bool> reaches(n, false), met(n, false);  // b by this strategy; the start leads there
    for (std::uint32_t round = 0; round < n; ++round)
      for (std::uint32_t s = 0; s < n; ++s)
        if (mdp_.choices(s) > 0)
          mdp_.for_each_outcome(s, choice_[s], [&](std::uint32_t t, LetterId l, double) {
            if (has_b(l) || reaches[t]) reaches[s] = true;
          });
    std::vector<std::uint32_t> open{mdp_.initial()};
    met[mdp_.initial()] = true;
    while (!open.empty()) {
      const std::uint32_t s = open.back();
      open.pop_back();
      if (!reaches[s]) return INFINITY;
      mdp_.for_each_outcome(s, choice_[s], [&](std::uint32_t t, LetterId l, double) {
        if (has_b(l) || met[t]) return;
        met[t] = true;
        open.push_back(t);
      });
    }
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1, 0));  // (1 − P) v = c
    for (std::uint32_t s = 0; s < n; ++s) {
      rows[s][s] = 1;
      if (!met[s]) continue;
      rows[s][n] = mdp_.cost(s, choice_[s]);
      mdp_.for_each_outcome(s, choice_[s], [&](std::uint32_t t, LetterId l, double p) {
        if (!has_b(l)) rows[s][t] -= p;
      });
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      std::swap(rows[i], *std::max_element(rows.begin() + i, rows.end(), [&](const auto& x, const auto& y) {
                  return std::abs(x[i]) < std::abs(y[i]);
                }));
      for (std::uint32_t j = 0; j < n; ++j) {
        const double factor = i == j ? 0 : rows[j][i] / rows[i][i];
        for (std::uint32_t k = i; k <= n && factor != 0; ++k) rows[j][k] -= factor * rows[i][k];
      }
    }
    return rows[mdp_.initial()][n] / rows[mdp_.initial()][mdp_.initial()];
  }

  const Mdp& mdp_;
  std::vector<std::uint32_t> choice_;
};

TEST(GreatestCost, IsThatOfTheWorstStrategy) {
  std::mt19937 random(11);
  int finite = 0;
  for (int i = 0; i < 4000; ++i) {
    const PlanningCase model{"", test::random_mdp(random), {}};
    const Mdp& mdp = std::get<Mdp>(model.model);
    const CaseTask task{"", "F b", CaseTask::Logic::Ltl, CaseTask::Query::MaxCost};
    const CaseAnswer found = answer(model, task, {.tolerance = 1e-9, .explain = false});
    ASSERT_EQ(found.status, CaseAnswer::Status::Solved) << i;
    const double expected = AllStrategies(mdp).greatest();
    if (expected == INFINITY) {
      ASSERT_EQ(found.value.lower, INFINITY) << i;
      continue;
    }
    finite += expected > 0 ? 1 : 0;
    ASSERT_NEAR(found.value.middle(), expected, 1e-7 * std::max(1.0, expected)) << i;
    ASSERT_LE(found.value.lower, expected * (1 + 1e-12)) << i;
    ASSERT_GE(found.value.upper, expected * (1 - 1e-12)) << i;
  }
  EXPECT_GT(finite, 100);
}

// The worst choice is any of the choices: it misses the goal for ever, by what is seen on the way or by staying away.
TEST(GreatestCost, IsInfiniteWhereAnyChoiceMissesTheGoal) {
  for (std::uint32_t bad = 0; bad < 4; ++bad)
    for (const bool stays : {false, true}) {
      MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
      const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}}),
                     b = builder.letter({ltl::Proposition{1}});
      builder.add_state();
      for (std::uint32_t k = 0; k < 3; ++k) {
        builder.add_choice(std::to_string(k), 1 + k);
        builder.add_outcome(k == bad && stays ? 1 : 2, k != bad ? b : stays ? none : a);
      }
      builder.add_state();
      builder.add_choice("stay");
      builder.add_outcome(1, none);
      builder.add_state();
      builder.add_choice("seen");
      builder.add_outcome(2, b);
      const PlanningCase model{"", std::move(builder).build(0, none), {}};
      const CaseTask task{"", "!a U b", CaseTask::Logic::Ltl, CaseTask::Query::MaxCost};
      const CaseAnswer found = answer(model, task, {.explain = false});
      if (bad < 3)
        EXPECT_EQ(found.value.lower, INFINITY) << bad << stays;
      else
        EXPECT_NEAR(found.value.middle(), 3, 1e-5);
    }
}

// One place, from which a step of cost 1 leads to b with this chance: 1 / chance steps are expected.
struct LongWait {
  explicit LongWait(double chance) : mdp(waits(chance)), arena(mdp.letters().vocabulary()) {}
  static Mdp waits(double chance) {
    MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
    const LetterId none = builder.letter({}), b = builder.letter({ltl::Proposition{1}});
    builder.add_state();
    builder.add_choice("try");
    builder.add_outcome(0, none, 1 - chance);
    builder.add_outcome(1, b, chance);
    builder.add_state();
    builder.add_choice("rest");
    builder.add_outcome(1, b);
    return std::move(builder).build(0, none);
  }
  std::optional<Bounds> greatest(const IterationOptions& limits) {
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F b", arena)), mdp.letters());
    return greatest_cost(ProductMdp<Mdp>::explore(mdp, task).value(), limits);
  }
  Mdp mdp;
  ltl::Arena arena;
};

TEST(GreatestCost, KeepsToItsLimits) {
  LongWait wait(1.0 / 1024);
  EXPECT_TRUE(wait.greatest({.tolerance = 1e-3, .sweeps = 100'000}));
  EXPECT_FALSE(wait.greatest({.tolerance = 1e-3, .sweeps = 100}));
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(wait.greatest({.tolerance = 1e-3, .stop = source.get_token()}));
}

// A tolerance so great that the first sweeps seem to have settled, and none: what is halved again and again is exact.
TEST(GreatestCost, IsBoundedWhateverTheTolerance) {
  LongWait rare(1.0 / 16), even(0.5);
  for (const double tolerance : {0.9, 0.5, 0.25, 0.1, 0.01}) {
    const auto found = rare.greatest({.tolerance = tolerance, .sweeps = 10'000});
    ASSERT_TRUE(found) << tolerance;
    EXPECT_LE(found->lower, 16 * (1 + 1e-12)) << tolerance;
    EXPECT_GE(found->upper, 16 * (1 - 1e-12)) << tolerance;
    EXPECT_LE(found->upper, found->lower * (1 + tolerance) * (1 + 1e-12)) << tolerance;
  }
  const auto exact = even.greatest({.tolerance = 0, .sweeps = 10'000});
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->lower, 2);
  EXPECT_EQ(exact->upper, 2);
}

TEST(GreatestCost, HasNoStrategyToWrite) {
  std::mt19937 random(1);
  const PlanningCase model{"", test::random_mdp(random), {}};
  const CaseTask task{"", "F b", CaseTask::Logic::Ltl, CaseTask::Query::MaxCost};
  EXPECT_THROW(answer(model, task, {.strategy = true}), std::invalid_argument);
  EXPECT_THROW(answer(model, task, {.method = CaseMethod::PolicyIteration}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
