// One objective under a bound on another, against all deterministic strategies of small random models, whose values may
// be infinite, and what mixtures of two of them attain.
#include "libplan/solve/several_objectives.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "libplan/solve/property_answer.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

constexpr std::uint32_t places = 4, pairs = 2 * places;  // pair: place, and whether `a` was met

// `a` holds in state 2, state 3 stays; costs 0 to 2, and in every state but 3 one or two choices. Both models differ in
// their costs alone.
struct TwoCosts {
  Mdp first, second;
};
TwoCosts random_costs(std::mt19937& random) {
  MdpBuilder one(ltl::Vocabulary({"a"})), other(ltl::Vocabulary({"a"}));
  for (std::uint32_t s = 0; s < places; ++s) {
    one.add_state(), other.add_state();
    for (std::uint32_t k = 0, n = s == 3 ? 1 : 1 + random() % 2; k < n; ++k) {
      const auto to = static_cast<std::uint32_t>(s == 3 ? 3 : random() % places);
      const auto else_to = static_cast<std::uint32_t>((to + 1 + random() % 3) % places);
      const double p = s == 3 || random() % 3 == 0 ? 1 : static_cast<double>(2 + random() % 5) / 8;
      const std::array<double, 2> costs{static_cast<double>(random() % 3), static_cast<double>(random() % 2)};
      const bool ends_free = s == 3 && random() % 2 == 0;
      for (MdpBuilder* builder : {&one, &other}) {
        builder->add_choice("c", ends_free ? 0 : costs[builder == &one ? 0 : 1]);
        const auto letter = [&](std::uint32_t t) {
          return builder->letter(t == 2 ? ltl::Letter({ltl::Proposition{0}}) : ltl::Letter());
        };
        builder->add_outcome(to, letter(to), p);
        if (p < 1) builder->add_outcome(else_to, letter(else_to), 1 - p);
      }
    }
  }
  const LetterId first = one.letter({}), second = other.letter({});
  return {std::move(one).build(0, first), std::move(other).build(0, second)};
}

using Rule = std::array<std::uint32_t, pairs>;  // by pair, the choice

struct Chain {  // of a rule
  Chain(const Mdp& mdp, const Rule& rule) {
    for (std::uint32_t i = 0; i < pairs; ++i)
      for (const ModelOutcome& o : mdp.outcomes(i / 2, rule[i]))
        move[i][2 * o.target + (o.target == 2 ? 1 : i % 2)] += o.probability;
    for (std::uint32_t i = 0; i < pairs; ++i) reach[i][i] = true;
    for (std::uint32_t round = 0; round < pairs; ++round)
      for (std::uint32_t i = 0; i < pairs; ++i)
        for (std::uint32_t j = 0; j < pairs; ++j)
          for (std::uint32_t k = 0; k < pairs; ++k)
            if (move[i][j] > 0 && reach[j][k]) reach[i][k] = true;
  }
  bool recurs(std::uint32_t i) const {  // is it come to again and again, once it was come to?
    for (std::uint32_t j = 0; j < pairs; ++j)
      if (reach[i][j] && !reach[j][i]) return false;
    return true;
  }
  // The sum of what the steps from pair 0 on are worth.
  double sum(const std::array<double, pairs>& worth) const {
    for (std::uint32_t i = 0; i < pairs; ++i)
      if (reach[0][i] && recurs(i) && worth[i] > 0) return std::numeric_limits<double>::infinity();
    std::array<double, pairs> at{};
    at[0] = 1;
    double out = 0;
    for (double left = 1; left > 1e-10;) {  // the chance of what does not recur
      std::array<double, pairs> next{};
      for (std::uint32_t i = 0; i < pairs; ++i) {
        out += at[i] * worth[i];
        for (std::uint32_t j = 0; j < pairs; ++j) next[j] += at[i] * move[i][j];
      }
      at = next;
      left = 0;
      for (std::uint32_t i = 0; i < pairs; ++i) left += recurs(i) ? 0 : at[i];
    }
    return out;
  }
  std::array<std::array<double, pairs>, pairs> move{};
  std::array<std::array<bool, pairs>, pairs> reach{};
};

// The value of an objective of a rule, more is better.
double worth_of(const Mdp& mdp, const Rule& rule, const Objective& objective) {
  const Chain chain(mdp, rule);
  std::array<double, pairs> worth{};
  for (std::uint32_t i = 0; i < pairs; ++i) {
    if (objective.costs != nullptr) worth[i] = objective.costs->cost(i / 2, rule[i]);
    for (std::uint32_t j = 1; objective.costs == nullptr && i % 2 == 0 && j < pairs; j += 2)
      worth[i] += chain.move[i][j];
  }
  const double sum = chain.sum(worth);
  return objective.greatest ? sum : -sum;
}

std::vector<Rule> all_rules(const Mdp& mdp) {
  std::vector<Rule> out{Rule{}};
  for (std::uint32_t i = 0; i < pairs; ++i) {
    const std::size_t before = out.size();
    for (std::uint32_t k = 1; k < mdp.choices(i / 2); ++k)
      for (std::size_t r = 0; r < before; ++r) {
        out.push_back(out[r]);
        out.back()[i] = k;
      }
  }
  return out;
}

// The best first coordinate of mixtures whose second one is at least the bound; nothing: there are none.
std::optional<double> best_mixture(const std::vector<std::array<double, 2>>& points, std::optional<double> bound) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::optional<double> best;
  const auto offer = [&](double x) { best = best ? std::max(*best, x) : x; };
  for (const auto& [x, y] : points) {
    if (!bound || y >= *bound - 1e-7) offer(x);
    for (const auto& [u, v] : points) {
      if (!bound || y >= *bound || v <= *bound || std::isinf(y)) continue;  // a little of the second, or some of it
      if (std::isinf(x) && x > 0 && u > -infinite) offer(infinite);
      const double share = std::isinf(v) ? 0 : (*bound - y) / (v - y);
      if (std::isfinite(x) && std::isfinite(u)) offer(x + share * (u - x));
      if (std::isfinite(x) && u > 0 && std::isinf(u)) offer(infinite);
      if (u == -infinite || x == -infinite) offer(-infinite);
    }
  }
  return best;
}

std::string shown(std::optional<double> value) { return value ? std::to_string(*value) : "infeasible"; }

// nullopt where the answer is refused by its name.
std::optional<std::string> answered(const Mdp& mdp, const Objective& wanted, const Objective* other, double bound) {
  std::vector<BoundedObjective> objectives{{wanted, {}}};
  if (other != nullptr) objectives.push_back({*other, bound});
  try {
    const auto found = several_objectives(mdp, objectives);
    if (found.value().kind == SeveralAnswer::Kind::Infeasible) return "infeasible";
    EXPECT_EQ(found->kind, SeveralAnswer::Kind::Value);
    const double value = wanted.greatest ? found->value : -found->value;
    return shown(value == 0 ? 0.0 : value);
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(refused.what(), std::string("a reward that is to be great may be infinite"));
    return std::nullopt;
  }
}

bool agree(const std::string& found, std::optional<double> expected) {
  if (!expected || std::isinf(*expected) || found == "infeasible" || found.find("inf") != std::string::npos)
    return found == shown(expected);
  return std::abs(std::stod(found) - *expected) <= 2e-5 * std::max(1.0, std::abs(*expected));
}

TEST(SeveralObjectives, AreThoseOfMixturesOfAllDeterministicStrategies) {
  std::mt19937 random(34);
  std::size_t refused = 0, infinite = 0, infeasible = 0, asked = 0;
  for (int i = 0; i < testing::scaled(100); ++i) {
    const TwoCosts models = random_costs(random);
    const std::vector<Rule> rules = all_rules(models.first);
    const std::array<Objective, 6> kinds{Objective{"F a", nullptr, true}, {"F a", nullptr, false},
                                         {"", &models.first, true},       {"", &models.first, false},
                                         {"", &models.second, true},      {"", &models.second, false}};
    for (std::size_t x = 0; x < kinds.size(); ++x)
      for (std::size_t y = 0; y <= kinds.size(); ++y) {
        if (y < kinds.size() && x / 2 == y / 2) continue;
        const Objective* other = y < kinds.size() ? &kinds[y] : nullptr;
        const double bound = y < 2 ? static_cast<double>(random() % 5) / 4 : static_cast<double>(random() % 8) + 0.3;
        std::vector<std::array<double, 2>> points;
        for (const Rule& rule : rules)
          points.push_back(
              {worth_of(models.first, rule, kinds[x]), other != nullptr ? worth_of(models.first, rule, *other) : 0});
        const auto oriented = other == nullptr ? std::nullopt : std::optional(other->greatest ? bound : -bound);
        const std::optional<double> expected = best_mixture(points, oriented);
        const auto found = answered(models.first, kinds[x], other, bound);
        ++asked;
        if (!found) {
          ++refused;
          continue;
        }
        ASSERT_TRUE(agree(*found, expected)) << "model " << i << ", objective " << x << " under " << y << " and "
                                             << bound << ": " << *found << ", expected " << shown(expected);
        infinite += expected && std::isinf(*expected) ? 1 : 0;
        infeasible += expected ? 0 : 1;
      }
  }
  EXPECT_GT(infinite, asked / 20);
  EXPECT_GT(infeasible, asked / 20);
  EXPECT_LT(refused, asked / 4);
}

}  // namespace
}  // namespace waymark::plan
