// The greatest expected cost against all strategies of small models, each solved as linear equations.
#include "libplan/solve/greatest_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

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

TEST(GreatestCost, HasNoStrategyToWrite) {
  std::mt19937 random(1);
  const PlanningCase model{"", test::random_mdp(random), {}};
  const CaseTask task{"", "F b", CaseTask::Logic::Ltl, CaseTask::Query::MaxCost};
  EXPECT_THROW(answer(model, task, {.strategy = true}), std::invalid_argument);
  EXPECT_THROW(answer(model, task, {.method = CaseMethod::PolicyIteration}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
