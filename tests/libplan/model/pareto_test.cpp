// The vertices of two objectives against the values of all deterministic strategies of small random models.
#include "libplan/solve/pareto.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "libplan/solve/property_answer.hpp"

namespace waymark::plan {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

constexpr std::uint32_t four = 4;  // states

// a holds in state 2, b in state 3, which stays at no cost; costs 0 to 2.
Mdp small_model(std::mt19937& random) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const std::array<LetterId, four> letters{builder.letter({}), builder.letter({}),
                                           builder.letter({ltl::Proposition{0}}),
                                           builder.letter({ltl::Proposition{1}})};
  for (std::uint32_t s = 0; s < four; ++s) {
    builder.add_state();
    const auto choices = s == 3 ? 1 : 1 + random() % 2;
    for (std::uint32_t k = 0; k < choices; ++k) {
      const auto one = static_cast<std::uint32_t>(s == 3 ? 3 : random() % four);
      const auto other = static_cast<std::uint32_t>((one + 1 + random() % 3) % four);
      builder.add_choice(k == 0 ? "l" : "r", s == 3 ? 0 : static_cast<double>(random() % 3));
      const double p = s == 3 ? 1 : static_cast<double>(2 + random() % 7) / 8;
      builder.add_outcome(one, letters[one], p);
      if (p < 1) builder.add_outcome(other, letters[other], 1 - p);
    }
  }
  return std::move(builder).build(0, letters[0]);
}

// By bits: a was met, b was met. A strategy chooses by state and bits.
struct ByBits {
  std::array<std::array<std::uint32_t, 4>, four> choice{};
};

struct Attained {
  double a = 0, b = 0, cost = 0;
};
Attained attained(const Mdp& mdp, const ByBits& strategy) {
  std::array<std::array<double, 4>, four> now{};
  now[0][0] = 1;
  Attained out;
  double lately = 1;  // what the last steps cost, fading
  for (int step = 0; step < 4'000; ++step) {
    std::array<std::array<double, 4>, four> next{};
    const double before = out.cost;
    double moved = 0;
    for (std::uint32_t s = 0; s < four; ++s)
      for (std::uint32_t m = 0; m < 4; ++m) {
        if (now[s][m] == 0) continue;
        const std::uint32_t k = strategy.choice[s][m];
        out.cost += now[s][m] * mdp.cost(s, k);
        for (const ModelOutcome& o : mdp.outcomes(s, k))
          next[o.target][m | (o.target == 2 ? 1U : 0U) | (o.target == 3 ? 2U : 0U)] += now[s][m] * o.probability;
      }
    for (std::uint32_t s = 0; s < four; ++s)
      for (std::uint32_t m = 0; m < 4; ++m) moved += std::abs(next[s][m] - now[s][m]);
    now = next;
    lately = 0.8 * lately + out.cost - before + moved;
    if (lately < 1e-11) break;
  }
  if (lately > 1e-4 && out.cost > 100) out.cost = INFINITY;
  for (std::uint32_t s = 0; s < four; ++s)
    for (std::uint32_t m = 0; m < 4; ++m) {
      if ((m & 1U) != 0) out.a += now[s][m];
      if ((m & 2U) != 0) out.b += now[s][m];
    }
  return out;
}

std::vector<Attained> all_attained(const Mdp& mdp) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> free;
  for (std::uint32_t s = 0; s < 3; ++s)
    for (std::uint32_t m = 0; m < 4; ++m)
      if (mdp.choices(s) > 1 && (s != 2 || (m & 1U) != 0)) free.emplace_back(s, m);
  std::vector<Attained> out;
  for (std::uint32_t code = 0; code < (1U << free.size()); ++code) {
    ByBits strategy;
    for (std::size_t i = 0; i < free.size(); ++i) strategy.choice[free[i].first][free[i].second] = code >> i & 1U;
    out.push_back(attained(mdp, strategy));
  }
  return out;
}

TEST(Pareto, IsTheHullOfAllDeterministicStrategies) {
  std::mt19937 random(31);
  std::size_t curves = 0;
  for (int i = 0; i < 150; ++i) {
    const Mdp mdp = small_model(random);
    const std::vector<Attained> all = all_attained(mdp);
    const Objective a{"F a", nullptr, true}, not_a{"F a", nullptr, false}, never_a{"G !a", nullptr, true},
        b{"F b", nullptr, true}, cheap{"", &mdp, false};
    const std::vector<std::pair<std::vector<Objective>, int>> questions{
        {{a, b}, 0}, {{a, cheap}, 1}, {{not_a, cheap}, 2}, {{never_a, b}, 3}};
    for (const auto& [objectives, kind] : questions) {
      const auto found = pareto(mdp, objectives);
      ASSERT_TRUE(found);
      const bool costs = kind == 1 || kind == 2;
      const auto pair = [&, k = kind](const Attained& o) {  // more is better
        const double one = k == 0 || k == 1 ? o.a : k == 2 ? -o.a : 1 - o.a;
        return std::pair{one, costs ? -o.cost : o.b};
      };
      for (int w = 0; w <= 20; ++w) {
        const double weight = w / 20.0;
        double best = nothing, front = nothing;
        for (const Attained& o : all) {
          if (costs && std::isinf(o.cost)) continue;
          const auto [x, y] = pair(o);
          best = std::max(best, weight * x + (1 - weight) * y);
        }
        for (const ParetoPoint& p : found->points) {
          const double x = kind == 2 ? -p.values[0] : p.values[0], y = costs ? -p.values[1] : p.values[1];
          front = std::max(front, weight * x + (1 - weight) * y);
        }
        if (best == nothing || front == nothing) {
          EXPECT_EQ(best, front) << i << ' ' << kind;
          continue;
        }
        EXPECT_NEAR(front, best, 2e-5 * std::max(1.0, std::abs(best))) << i << ' ' << kind << " weight " << weight;
      }
      if (found->points.size() > 1) ++curves;
      for (const ParetoPoint& p : found->points)
        for (std::size_t o = 0; o < 2; ++o)
          EXPECT_NEAR(p.values[o], p.re_evaluated[o].middle(), 1e-5 * std::max(1.0, p.values[o]));
    }
  }
  EXPECT_GT(curves, 50U);
}

TEST(Pareto, IsOfOneObjectiveOrTwo) {
  MdpBuilder builder(ltl::Vocabulary({"a"}));
  const LetterId a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("stay");
  builder.add_outcome(0, a);
  const Mdp mdp = std::move(builder).build(0, a);
  EXPECT_THROW(pareto(mdp, {}), std::invalid_argument);
  EXPECT_THROW(pareto(mdp, {{"F a"}, {"G a"}, {"X a"}}), std::invalid_argument);
  EXPECT_EQ(pareto(mdp, {{"F a"}, {"X a"}}).value().points.size(), 1U);
}

}  // namespace
}  // namespace waymark::plan
