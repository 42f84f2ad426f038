#include "libparser/training/learn_ranker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libparser/supervision/examples.hpp"

namespace waymark::parser {
namespace {

constexpr std::uint32_t feature_count = 6;

WeightTable random_weights(std::mt19937_64& random) {
  WeightTable weights(1);
  for (std::uint32_t f = 0; f < feature_count; ++f)
    *weights.row(weights.add(f)) = std::uniform_real_distribution<float>(-1, 1)(random);
  return weights;
}

// Four candidates of one to three bundles out of five; one or two are right, the last may be the rival.
LabelledDecision random_decision(std::mt19937_64& random) {
  LabelledDecision decision;
  for (int b = 0; b < 5; ++b) {
    auto& bundle = decision.bundles.emplace_back();
    for (std::uint64_t n = random() % 4; n > 0; --n)
      bundle.push_back({WeightRow{static_cast<std::uint32_t>(random() % feature_count)},
                        std::uniform_real_distribution<float>(-1, 1)(random)});
  }
  for (int i = 0; i < 4; ++i) {
    auto& candidate = decision.candidates.emplace_back();
    for (std::uint64_t n = 1 + random() % 3; n > 0; --n) candidate.push_back(static_cast<std::uint32_t>(random() % 5));
  }
  decision.right = random() % 2 == 0 ? std::vector<std::size_t>{1} : std::vector<std::size_t>{0, 2};
  if (random() % 2 == 0) decision.rival = 3;
  return decision;
}

// The definition; for one right candidate or no rival.
double loss(const WeightTable& weights, const LabelledDecision& decision, double against_rival) {
  std::vector<double> score;
  for (const auto& candidate : decision.candidates) {
    score.push_back(0);
    for (const std::uint32_t bundle : candidate)
      for (const auto& [row, value] : decision.bundles[bundle])
        score.back() += static_cast<double>(weights.weight(row, 0)) * static_cast<double>(value);
  }
  double all = 0, right = 0;
  for (const double s : score) all += std::exp(s);
  for (const std::size_t i : decision.right) right += std::exp(score[i]);
  const double behind = decision.rival ? score[*decision.rival] - score[decision.right.front()] : 0;
  return -std::log(right / all) + (decision.rival ? against_rival * std::log(1 + std::exp(1 + behind)) : 0.0);
}

TEST(LearnRanker, StepsAlongTheGradientOfItsLoss) {
  constexpr double large = 1e4,
                   against_rival = 0.7;  // squares that no gradient adds to: every step is rate · g / 100
  std::mt19937_64 random(3);
  for (int round = 0; round < 200; ++round) {
    const WeightTable before = random_weights(random);
    std::vector<LabelledDecision> decisions{random_decision(random)};
    WeightTable after = before;
    learn_ranker(after, decisions,
                 {.epochs = 1, .rate = 1, .decay = 0, .first_squares = large, .against_rival = against_rival},
                 [](double) {});
    for (std::uint32_t f = 0; f < feature_count; ++f) {
      constexpr float step = 0.01F;
      WeightTable more = before, less = before;
      *more.row({f}) += step, *less.row({f}) -= step;
      const double slope =
          (loss(more, decisions[0], against_rival) - loss(less, decisions[0], against_rival)) / (2.0 * step);
      const double moved = static_cast<double>(after.weight({f}, 0)) - static_cast<double>(before.weight({f}, 0));
      EXPECT_NEAR(100 * moved, -slope, 2e-3) << "round " << round << ", feature " << f;
    }
  }
}

TEST(LearnRanker, AFeatureOfTooFewMapsIsLeftOut) {
  WeightTable weights(1);
  const auto decision = [&](std::size_t map, std::uint64_t own) {
    LabelledDecision out = numbered({{{{own, 1}, {100, 1}}, {}}, {{0}, {1}}}, weights);
    out.map = map;
    out.right = {0};
    return out;
  };
  std::vector<LabelledDecision> decisions{decision(0, 7), decision(1, 8), decision(0, 8)};
  learn_ranker(weights, decisions, {.epochs = 3, .least_maps = 2}, [](double) {});
  EXPECT_EQ(*weights.row(weights.find(7).value()), 0.0F);
  EXPECT_GT(*weights.row(weights.find(8).value()), 0.0F);
  EXPECT_GT(*weights.row(weights.find(100).value()), 0.0F);
}

TEST(LearnRanker, SaysThatItWasStopped) {
  std::mt19937_64 random(4);
  WeightTable weights = random_weights(random);
  std::vector<LabelledDecision> decisions{random_decision(random)};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(learn_ranker(weights, decisions, {.stop = stop.get_token()}, [](double) {}), Stopped);
}

// A third domain, as small as one can be: a word means one of four doors.
class Doors {
 public:
  struct Map {};
  struct Text {
    std::uint64_t word;
    std::size_t door;  // that it means
  };
  using Candidates = std::vector<std::size_t>;
  using Route = std::size_t;

  static ltl::Vocabulary vocabulary(const Map&) { return ltl::Vocabulary({"north", "east", "south", "west"}); }
  static std::size_t map_of(const Text&) { return 0; }
  static Candidates candidates(const Text&) { return {0, 1, 2, 3}; }
  static CandidateFeatures features(const Text& text, const Candidates& doors) {
    CandidateFeatures out;
    for (const std::size_t door : doors) {
      out.candidates.push_back({static_cast<std::uint32_t>(door)});
      out.bundles.push_back({{4 * text.word + door, 1}});
    }
    return out;
  }
  static Route execute(std::size_t door) { return door; }
  static bool right(const Text& text, Route door) { return door == text.door; }
};

TEST(LearnRanker, AnotherDomainNeedsNoLearnerOfItsOwn) {
  static_assert(Domain<Doors> && !DomainWithRivals<Doors>);
  Doors doors;
  const std::vector<Doors::Text> texts{{7, 2}, {8, 0}, {9, 2}, {7, 2}};
  WeightTable weights(1);
  learn_ranker(doors, std::span<const Doors::Text>(texts), weights, {}, [](double) {});
  for (const Doors::Text& text : texts) {
    std::vector<double> p = scores(weights, Doors::features(text, Doors::candidates(text)));
    normalise(p);
    for (std::size_t door = 0; door < p.size(); ++door) EXPECT_EQ(p[door] > 0.25, door == text.door);
  }
}

}  // namespace
}  // namespace waymark::parser
