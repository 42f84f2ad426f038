// Models with labels on states: parts, levels and quotients of them, state by state as they are defined.
#include "libplan/solve/state_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "libplan/solve/finite_horizon.hpp"
#include "libplan/solve/product_search.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using Labels = std::vector<ltl::Letter>;  // by state

// Every state has a letter over {a, b}, a name, and choices whose costs are whole numbers, some of them 0.
struct Labelled {
  Labels label;
  Mdp mdp;
};
Labelled labelled(ltl::Random& random) {
  const std::size_t states = 1 + random.below(6);
  Labels label(states);
  for (ltl::Letter& letter : label)
    for (std::uint32_t p = 0; p < 2; ++p)
      if (random.below(2) == 0) letter.insert(ltl::Proposition{p});
  MdpBuilder builder(testing::vocabulary_ab());
  for (std::size_t s = 0; s < states; ++s) {
    builder.add_state("s" + std::to_string(s));
    for (std::size_t k = 1 + random.below(3); k > 0; --k) {
      builder.add_choice("c" + std::to_string(random.below(3)), static_cast<double>(random.below(3)));
      const double p = 0.25 * static_cast<double>(1 + random.below(4));
      for (const double chance : {p, 1 - p}) {
        const auto target = static_cast<std::uint32_t>(random.below(states));
        if (chance > 0) builder.add_outcome(target, builder.letter(label[target]), chance);
      }
    }
  }
  const auto first = static_cast<std::uint32_t>(random.below(states));
  const LetterId letter = builder.letter(label[first]);
  return {label, std::move(builder).build(first, letter)};
}

std::uint32_t old_state(const std::string& name) { return static_cast<std::uint32_t>(std::stoul(name.substr(1))); }

std::set<std::string> names_in(const Mdp& mdp, LetterId letter) {
  std::set<std::string> out;
  for (std::uint32_t p = 0; p < mdp.letters().vocabulary().size(); ++p)
    if (mdp.letters()[letter].contains(ltl::Proposition{p})) out.insert(mdp.letters().vocabulary().name({p}));
  return out;
}
std::set<std::string> names_of(const ltl::Letter& letter) {
  std::set<std::string> out;
  for (std::uint32_t p = 0; p < 2; ++p)
    if (letter.contains(ltl::Proposition{p})) out.insert(p == 0 ? "a" : "b");
  return out;
}

TEST(StateModel, BeginsAnywhereWithWhatIsReachable) {
  ltl::Random random(112);
  for (int trial = 0; trial < waymark::testing::scaled(500); ++trial) {
    const Labelled drawn_model = labelled(random);
    const Labels& label = drawn_model.label;
    const Mdp& mdp = drawn_model.mdp;
    const auto start = static_cast<std::uint32_t>(random.below(mdp.states()));
    std::vector<bool> truth(mdp.states());
    for (std::size_t s = 0; s < truth.size(); ++s) truth[s] = random.below(2) == 0;
    const Mdp part = beginning_at(mdp, start, letters_of_states(mdp), {{"more", truth}});
    const auto expected_letter = [&](std::uint32_t s) {
      std::set<std::string> out = names_of(label[s]);
      if (truth[s]) out.insert("more");
      return out;
    };
    ASSERT_EQ(part.initial(), 0U);
    ASSERT_EQ(part.name(0), mdp.name(start));
    bool is_entered = start == mdp.initial();  // else nothing says which letter a state has
    for (std::uint32_t s = 0; s < mdp.states(); ++s)
      for (std::uint32_t k = 0; k < mdp.choices(s); ++k)
        for (const ModelOutcome& o : mdp.outcomes(s, k)) is_entered = is_entered || o.target == start;
    if (is_entered) {
      EXPECT_EQ(names_in(part, part.initial_letter()), expected_letter(start)) << testing::show(mdp);
    }
    std::set<std::uint32_t> reached{start};
    for (std::size_t before = 0; before != reached.size();) {
      before = reached.size();
      for (const std::uint32_t s : std::set<std::uint32_t>(reached))
        for (std::uint32_t k = 0; k < mdp.choices(s); ++k)
          for (const ModelOutcome& o : mdp.outcomes(s, k)) reached.insert(o.target);
    }
    ASSERT_EQ(part.states(), reached.size()) << testing::show(mdp);
    for (std::uint32_t s = 0; s < part.states(); ++s) {
      const std::uint32_t old = old_state(part.name(s));
      ASSERT_EQ(reached.erase(old), 1U);
      ASSERT_EQ(part.choices(s), mdp.choices(old));
      for (std::uint32_t k = 0; k < part.choices(s); ++k) {
        EXPECT_EQ(part.action(s, k), mdp.action(old, k));
        EXPECT_EQ(part.cost(s, k), mdp.cost(old, k));
        ASSERT_EQ(part.outcomes(s, k).size(), mdp.outcomes(old, k).size());
        for (std::size_t i = 0; i < part.outcomes(s, k).size(); ++i) {
          const ModelOutcome &o = part.outcomes(s, k)[i], &was = mdp.outcomes(old, k)[i];
          EXPECT_EQ(old_state(part.name(o.target)), was.target);
          EXPECT_EQ(o.probability, was.probability);
          EXPECT_EQ(names_in(part, o.letter), expected_letter(was.target));
        }
      }
    }
  }
}

// Places with what was spent on the way to them, until that is more than the budget.
TEST(StateModel, SpendsABudgetStepByStep) {
  ltl::Random random(113);
  constexpr std::uint64_t over = UINT64_MAX;
  int ended = 0;
  for (int trial = 0; trial < waymark::testing::scaled(500); ++trial) {
    const Labelled drawn_model = labelled(random);
    const Labels& label = drawn_model.label;
    const Mdp& mdp = drawn_model.mdp;
    const std::uint64_t budget = random.below(6);
    const auto found = spending(mdp, budget, "within", {.states = SIZE_MAX});
    ASSERT_TRUE(found);
    std::map<std::uint32_t, std::pair<std::uint32_t, std::uint64_t>> place{{found->initial(), {mdp.initial(), 0}}};
    std::set<std::pair<std::uint32_t, std::uint64_t>> places{{mdp.initial(), 0}};
    std::vector<std::uint32_t> open{found->initial()};
    const auto meet = [&](std::uint32_t state, std::pair<std::uint32_t, std::uint64_t> at) {
      const auto [known, fresh] = place.emplace(state, at);
      EXPECT_EQ(known->second, at) << testing::show(mdp);
      if (!fresh) return;
      open.push_back(state);
      EXPECT_TRUE(places.insert(at).second) << testing::show(mdp);
    };
    const auto with = [](std::set<std::string> names) {
      names.insert("within");
      return names;
    };
    EXPECT_EQ(names_in(*found, found->initial_letter()), with(names_of(label[mdp.initial()])));
    while (!open.empty()) {
      const std::uint32_t state = open.back();
      open.pop_back();
      const auto [s, spent] = place.at(state);
      if (spent == over) {
        ++ended;
        ASSERT_EQ(found->choices(state), 1U);
        EXPECT_EQ(found->cost(state, 0), 0);
        EXPECT_EQ(found->outcome(state, 0, 0).target, state);
        EXPECT_TRUE(names_in(*found, found->outcome(state, 0, 0).letter).empty());
        continue;
      }
      ASSERT_EQ(found->choices(state), mdp.choices(s));
      for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
        EXPECT_EQ(found->cost(state, k), 0);
        EXPECT_EQ(found->action(state, k), mdp.action(s, k));
        const std::uint64_t now = spent + static_cast<std::uint64_t>(mdp.cost(s, k));
        if (now > budget) {
          ASSERT_EQ(found->outcome_count(state, k), 1U);
          EXPECT_TRUE(names_in(*found, found->outcome(state, k, 0).letter).empty());
          meet(found->outcome(state, k, 0).target, {0, over});
          continue;
        }
        ASSERT_EQ(found->outcome_count(state, k), mdp.outcome_count(s, k));
        for (std::uint32_t i = 0; i < mdp.outcome_count(s, k); ++i) {
          const ModelOutcome &o = found->outcome(state, k, i), &was = mdp.outcome(s, k, i);
          EXPECT_EQ(o.probability, was.probability);
          EXPECT_EQ(names_in(*found, o.letter), with(names_of(label[was.target])));
          meet(o.target, {was.target, now});
        }
      }
    }
    EXPECT_EQ(found->states(), place.size());
    EXPECT_TRUE(spending(mdp, budget, "within", {.states = place.size()}));
    if (place.size() > 1) {
      EXPECT_FALSE(spending(mdp, budget, "within", {.states = place.size() - 1}));
    }
    ASSERT_FALSE(HasFailure()) << testing::show(mdp);
  }
  EXPECT_GT(ended, waymark::testing::scaled(200));
}

// Every end component is one state, that may end; choices that stay in one are gone.
TEST(StateModel, EndComponentsBecomeStatesThatMayEnd) {
  ltl::Random random(114);
  int merged = 0;
  for (int trial = 0; trial < waymark::testing::scaled(500); ++trial) {
    const Mdp mdp = labelled(random).mdp;
    const bool free_only = random.below(2) == 0;
    const EndComponents components =
        free_only ? end_components_of(mdp, [&mdp](std::uint32_t s, std::uint32_t k) { return mdp.cost(s, k) == 0; })
                  : end_components_of(mdp);
    const Mdp found = ending_in_components(mdp, components);
    std::vector<std::vector<std::uint32_t>> members;
    std::vector<std::uint32_t> number(mdp.states(), UINT32_MAX);
    std::vector<std::uint32_t> order{mdp.initial()};
    for (std::uint32_t s = 0; s < mdp.states(); ++s)
      if (s != mdp.initial()) order.push_back(s);
    for (const std::uint32_t s : order) {
      for (std::uint32_t other = 0; other < mdp.states(); ++other)
        if (number[other] != UINT32_MAX && components.of[s] != EndComponents::none &&
            components.of[other] == components.of[s])
          number[s] = number[other];
      if (number[s] == UINT32_MAX) {
        number[s] = static_cast<std::uint32_t>(members.size());
        members.emplace_back();
      }
      members[number[s]].push_back(s);
    }
    const auto last = static_cast<std::uint32_t>(members.size());
    ASSERT_EQ(found.states(), last + 1U) << testing::show(mdp);
    ASSERT_EQ(found.initial(), 0U);
    const std::set<std::string> end{"end"};
    EXPECT_TRUE(names_in(found, found.initial_letter()).empty());
    for (std::uint32_t i = 0; i <= last; ++i) {
      std::uint32_t k = 0;
      for (const std::uint32_t s : i < last ? members[i] : std::vector<std::uint32_t>{})
        for (std::uint32_t c = 0; c < mdp.choices(s); ++c) {
          bool inside = components.of[s] != EndComponents::none;
          for (const ModelOutcome& o : mdp.outcomes(s, c))
            inside = inside && components.of[o.target] == components.of[s];
          ASSERT_EQ(leaves(mdp, s, c, components), !inside) << testing::show(mdp);
          if (inside) continue;
          ASSERT_LT(k, found.choices(i)) << testing::show(mdp);
          EXPECT_EQ(found.cost(i, k), mdp.cost(s, c));
          EXPECT_EQ(found.action(i, k), mdp.action(s, c));
          ASSERT_EQ(found.outcome_count(i, k), mdp.outcome_count(s, c));
          for (std::uint32_t o = 0; o < mdp.outcome_count(s, c); ++o) {
            EXPECT_EQ(found.outcome(i, k, o).target, number[mdp.outcome(s, c, o).target]);
            EXPECT_EQ(found.outcome(i, k, o).probability, mdp.outcome(s, c, o).probability);
            EXPECT_TRUE(names_in(found, found.outcome(i, k, o).letter).empty());
          }
          ++k;
        }
      if (i == last || components.of[members[i][0]] != EndComponents::none) {
        ASSERT_LT(k, found.choices(i)) << testing::show(mdp);
        EXPECT_EQ(found.cost(i, k), 0);
        EXPECT_EQ(found.outcome(i, k, 0).target, last);
        EXPECT_EQ(names_in(found, found.outcome(i, k, 0).letter), end);
        merged += i < last && members[i].size() > 1 ? 1 : 0;
        ++k;
      }
      EXPECT_EQ(found.choices(i), k) << testing::show(mdp);
    }
    ASSERT_FALSE(HasFailure()) << testing::show(mdp);
  }
  EXPECT_GT(merged, waymark::testing::scaled(50));
}

TEST(StateModel, FreeForEverIsTheGreatestSetThatFreeChoicesKeep) {
  ltl::Random random(115);
  int some = 0;
  for (int trial = 0; trial < waymark::testing::scaled(1'000); ++trial) {
    const Mdp mdp = labelled(random).mdp;
    std::vector<bool> expected(mdp.states(), false);
    for (std::uint32_t bits = 0; bits < 1U << mdp.states(); ++bits) {
      bool all = true;
      for (std::uint32_t s = 0; s < mdp.states(); ++s) {
        bool kept = ((bits >> s) & 1U) == 0;
        for (std::uint32_t k = 0; k < mdp.choices(s) && !kept; ++k) {
          kept = mdp.cost(s, k) == 0;
          for (const ModelOutcome& o : mdp.outcomes(s, k)) kept = kept && ((bits >> o.target) & 1U) != 0;
        }
        all = all && kept;
      }
      for (std::uint32_t s = 0; s < mdp.states(); ++s)
        if (all && ((bits >> s) & 1U) != 0) expected[s] = true;
    }
    ASSERT_EQ(free_for_ever(mdp), expected) << testing::show(mdp);
    some += std::count(expected.begin(), expected.end(), true) > 0 ? 1 : 0;
  }
  EXPECT_GT(some, waymark::testing::scaled(200));
}

// What the steps that are left cost, or the choice after them.
double by_recursion(const Mdp& mdp, std::uint32_t s, std::uint64_t steps, const Horizon& asked) {
  double best = asked.greatest ? -1 : INFINITY;
  if (steps == 0 && !asked.instantaneous) return 0;
  for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
    double sum = steps == 0 || !asked.instantaneous ? mdp.cost(s, k) : 0;
    for (const ModelOutcome& o : mdp.outcomes(s, k))
      if (steps > 0) sum += asked.discount * o.probability * by_recursion(mdp, o.target, steps - 1, asked);
    best = asked.greatest ? std::max(best, sum) : std::min(best, sum);
  }
  return best;
}

TEST(FiniteHorizon, CostsAreThoseOfTheRecursion) {
  ltl::Random random(116);
  for (int trial = 0; trial < waymark::testing::scaled(200); ++trial) {
    const Mdp mdp = labelled(random).mdp;
    for (const bool instantaneous : {false, true})
      for (const bool greatest : {false, true})
        for (const double discount : {1.0, 0.5}) {
          const Horizon asked{random.below(5), instantaneous, greatest, discount};
          const auto found = expected_cost(mdp, asked);
          ASSERT_TRUE(found);
          EXPECT_NEAR(*found, by_recursion(mdp, mdp.initial(), asked.steps, asked), 1e-12) << testing::show(mdp);
        }
  }
}

// Where a run ends nothing is to be paid any more.
TEST(FiniteHorizon, NothingIsPaidWhereThereIsNoChoice) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({});
  builder.add_state();
  builder.add_choice("on", 2);
  builder.add_outcome(1, none);
  builder.add_state();
  const Mdp mdp = std::move(builder).build(0, none);
  for (const bool greatest : {false, true})
    for (std::uint64_t steps = 0; steps < 4; ++steps) {
      EXPECT_EQ(expected_cost(mdp, {steps, false, greatest}), steps == 0 ? 0 : 2) << steps;
      EXPECT_EQ(expected_cost(mdp, {steps, true, greatest}), steps == 0 ? 2 : 0) << steps;
    }
}

TEST(UniformCost, IsThatOfAllChoicesOrOfNone) {
  ltl::Random random(117);
  int uniform = 0;
  for (int trial = 0; trial < waymark::testing::scaled(500); ++trial) {
    const Mdp mdp = labelled(random).mdp;
    std::set<double> costs;
    for (std::uint32_t s = 0; s < mdp.states(); ++s)
      for (std::uint32_t k = 0; k < mdp.choices(s); ++k) costs.insert(mdp.cost(s, k));
    EXPECT_EQ(uniform_cost(mdp), costs.size() == 1 ? std::optional(*costs.begin()) : std::nullopt);
    uniform += costs.size() == 1 ? 1 : 0;
  }
  EXPECT_GT(uniform, waymark::testing::scaled(20));
}

}  // namespace
}  // namespace waymark::plan
