// The vertices of two objectives against the values of all deterministic strategies of small random models.
#include "libplan/solve/pareto.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
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

TEST(Pareto, DecisionsTellWhatBecameOfEachFormula) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}}),
                 b = builder.letter({ltl::Proposition{1}});
  builder.add_state();
  builder.add_choice("toss", 1);
  builder.add_outcome(1, a, 0.5);
  builder.add_outcome(2, b, 0.5);
  for (const std::uint32_t s : {1U, 2U}) {
    builder.add_state();
    builder.add_choice("rest", 0);
    builder.add_outcome(s, none, 1);
  }
  const Mdp mdp = std::move(builder).build(0, none);
  const auto told = [&](const std::vector<Objective>& objectives) {
    std::string out;
    const auto found = pareto(mdp, objectives);
    for (const ParetoPoint& point : found.value().points)
      for (const ParetoDecision& d : point.decisions)
        out += std::to_string(d.state) + " [" + d.memory + "] " + d.action + "; ";
    return out;
  };
  const Objective until{"!b U a", nullptr, true}, meets_b{"F b", nullptr, true}, cheap{"", &mdp, false};
  EXPECT_EQ(told({until, meets_b}), "0 [1,1] toss; 1 [yes,1] rest; 2 [no,yes] rest; ");
  EXPECT_EQ(told({meets_b, cheap}), "0 [1] toss; 1 [1] rest; 2 [yes] rest; ");
  EXPECT_EQ(told({cheap, until}), "0 [1] toss; 1 [yes] rest; 2 [no] rest; ");
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

// ---- one objective under a bound on the other: mixtures of two deterministic strategies attain the best value

PrismProperty objective(const Mdp& mdp, const std::string& formula, bool greatest) {
  PrismProperty out;
  out.about_rewards = formula.empty();
  const auto most = out.about_rewards ? CaseTask::Query::MaxCost : CaseTask::Query::MaxProbability;
  const auto least = out.about_rewards ? CaseTask::Query::MinCost : CaseTask::Query::MinProbability;
  out.task = {"", formula, CaseTask::Logic::Ltl, greatest ? most : least};
  out.model = std::make_shared<const PlanningCase>(PlanningCase{"", mdp, {}});
  return out;
}
PrismProperty bounded(PrismProperty objective, bool greatest, double bound) {
  objective.comparison = greatest ? ">=" : "<=";
  objective.bound = bound;
  return objective;
}
PropertyAnswer answered(std::vector<PrismProperty> objectives, bool swapped) {
  PrismProperty out;
  out.ask = PrismProperty::Ask::Multi;
  out.model = objectives[0].model;
  out.nested = std::move(objectives);
  if (swapped) std::swap(out.nested[0], out.nested[1]);
  return answer(out, {.tolerance = 1e-8, .explain = false});
}

using Point = std::pair<double, double>;  // more is better
double best_under(const std::vector<Point>& points, double bound) {
  double best = nothing;
  for (const auto& [x, y] : points)
    for (const auto& [u, v] : points) {
      if (y >= bound) best = std::max(best, x);
      if (y < bound && v >= bound) best = std::max(best, x + (bound - y) / (v - y) * (u - x));
    }
  return best;
}

TEST(Pareto, AnswersUnderABoundAreThoseOfMixturesOfTwoStrategies) {
  std::mt19937 random(32);
  std::size_t between = 0, infeasible = 0;
  const struct {
    const char *wanted, *bounded;  // "": the cost
    bool wanted_greatest, bounded_greatest;
  } questions[] = {{"F a", "F b", true, true},
                   {"F a", "", true, false},
                   {"", "F a", false, true},
                   {"F a", "F b", false, true},
                   {"F b", "F a", true, false}};
  for (int i = 0; i < 60; ++i) {
    const Mdp mdp = small_model(random);
    const std::vector<Attained> all = all_attained(mdp);
    for (const auto& q : questions) {
      const auto oriented = [&](const char* formula, bool greatest, const Attained& o) {
        const double value = *formula == 0 ? o.cost : formula == std::string("F a") ? o.a : o.b;
        return greatest ? value : -value;
      };
      std::vector<Point> points;
      double least = INFINITY, most = nothing;
      for (const Attained& o : all) {
        const Point p{oriented(q.wanted, q.wanted_greatest, o), oriented(q.bounded, q.bounded_greatest, o)};
        if (std::isinf(p.first) || std::isinf(p.second)) continue;
        points.push_back(p);
        least = std::min(least, p.second);
        most = std::max(most, p.second);
      }
      if (points.empty()) continue;
      const PrismProperty wanted = objective(mdp, q.wanted, q.wanted_greatest);
      for (const double share : {-0.1, 0.3, 0.7, 0.99}) {
        const double bound = least + share * (most - least) - 1e-4;
        const double best = best_under(points, bound), near = 1e-4 * std::max(1.0, std::abs(best));
        const PrismProperty other = bounded(objective(mdp, q.bounded, q.bounded_greatest), q.bounded_greatest,
                                            q.bounded_greatest ? bound : -bound);
        for (const bool swapped : {false, true}) {
          const PropertyAnswer found = answered({wanted, other}, swapped);
          ASSERT_EQ(found.answer.status, CaseAnswer::Status::Solved) << i << ' ' << q.wanted << ' ' << q.bounded;
          ASSERT_FALSE(found.verdict) << "a value was asked for";
          ASSERT_NEAR(found.answer.value.middle(), q.wanted_greatest ? best : -best, near)
              << i << ' ' << q.wanted << ' ' << q.bounded << " bound " << bound;
          for (const double off : {-5 * near, 5 * near}) {
            const double asked = q.wanted_greatest ? best + off : -best - off;
            const PropertyAnswer verdict = answered({bounded(wanted, q.wanted_greatest, asked), other}, swapped);
            ASSERT_EQ(verdict.verdict, off < 0) << i << ' ' << q.wanted << ' ' << q.bounded << " bound " << bound;
            ASSERT_EQ(verdict.answer.value.middle(), off < 0 ? 1 : 0);
          }
        }
        between += std::none_of(points.begin(), points.end(),
                                [&](const Point& p) { return std::abs(p.first - best) < near && p.second >= bound; })
                       ? 1
                       : 0;
      }
      const double beyond = most + 0.01;
      const PropertyAnswer none = answered({wanted, bounded(objective(mdp, q.bounded, q.bounded_greatest),
                                                            q.bounded_greatest, q.bounded_greatest ? beyond : -beyond)},
                                           false);
      ASSERT_EQ(none.answer.status, CaseAnswer::Status::Infeasible) << i << ' ' << q.wanted << ' ' << q.bounded;
      ++infeasible;
    }
  }
  EXPECT_GT(between, 50U);
  EXPECT_GT(infeasible, 200U);
}

TEST(Pareto, OneObjectiveAloneIsComparedWithItsOwnBound) {
  std::mt19937 random(33);
  for (int i = 0; i < 40; ++i) {
    const Mdp mdp = small_model(random);
    double most = nothing, least = INFINITY;
    for (const Attained& o : all_attained(mdp)) most = std::max(most, o.a), least = std::min(least, o.a);
    for (const bool greatest : {true, false}) {
      const PrismProperty a = objective(mdp, "F a", greatest);
      const double best = greatest ? most : least;
      EXPECT_NEAR(answered({a}, false).answer.value.middle(), best, 1e-5) << i;
      for (const double off : {-1e-3, 1e-3})
        EXPECT_EQ(answered({bounded(a, greatest, best + off)}, false).verdict, greatest == (off < 0)) << i;
    }
  }
}

TEST(Pareto, PrintedCurvesAreReadPointByPoint) {
  const std::vector<ParetoPoint> curve{{{0.25, 7}, {}, {}}, {{0.5, 9}, {}, {}}};
  EXPECT_EQ(agrees("[(0.25,7),(0.5,9)]", curve), true);
  EXPECT_EQ(agrees("[ (0.5, 9), (0.25, 7) ]", curve), true);
  EXPECT_EQ(agrees("[(0.25,9),(0.5,7)]", curve), false);
  EXPECT_EQ(agrees("[(0.25,7),(9,0.5)]", curve), false);
  EXPECT_EQ(agrees("[(0.25,7),(0.25,7)]", curve), true) << "each printed point is one of the curve";
  EXPECT_EQ(agrees("[(0.25,7)]", curve), false);
  EXPECT_EQ(agrees("[(0.25,7),(0.5,9),(0.5,9)]", curve), false);
  EXPECT_EQ(agrees("[(0.25,7),(0.5,9),(1,11)]", {curve[0], curve[1], {{1, 11}, {}, {}}}), true);
  EXPECT_FALSE(agrees("[(0.25),(0.5,9)]", curve));
  EXPECT_FALSE(agrees("0.25, 7", curve));
}

}  // namespace
}  // namespace waymark::plan
