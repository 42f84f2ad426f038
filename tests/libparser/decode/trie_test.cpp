// Decoding and the gradient of the marginal likelihood, both against enumeration on a small vocabulary.
#include "libparser/decode/linear_trie.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <span>

#include "libparser/corpus/token.hpp"
#include "libparser/decode/best_first.hpp"

namespace waymark::parser {
namespace {

const ltl::Vocabulary few_propositions({"chair", "ahead_wall", "place_1", "turned_left"});

class Decoding : public ::testing::Test {
 protected:
  Decoding() : features(sentence_features({tokenize("walk to the chair and turn left"), false}, model.words)) {
    std::mt19937_64 random(5);
    const auto fill = [&](std::uint64_t feature) {
      float* const row = model.weights.row(model.weights.add(feature));
      for (std::size_t c = 0; c < model.weights.columns(); ++c)
        row[c] = static_cast<float>(static_cast<double>(random() % 1000) / 2000.0 - 0.25);
    };
    for (const auto& kind : features.by_context)
      for (const auto& step : kind)
        for (std::size_t i = 0; i < step.size(); i += 5) fill(step[i]);
    for (std::size_t last = 0; last < model.language.grammar().tokens(); ++last)
      fill(last_token_feature({0, 1, static_cast<Token>(last), 0}));
    fill(mention_feature({0, 0, 0, 0}));
  }

  // p(program | sentence), token by token.
  double probability(const Program& program) {
    Scorer scorer(model, features);
    double log_probability = 0;
    PrefixState state;
    Choice choice = first_choice();
    std::vector<float> log_p(model.language.grammar().tokens());
    for (Token token : model.language.grammar().tokens_of(program)) {
      const bool forced = model.language.grammar().forced(state).has_value();
      if (!forced) {
        scorer.log_probabilities(scorer.groups(choice), model.language.grammar().choices(state), log_p.data());
        log_probability += static_cast<double>(log_p[token]);
      }
      state = model.language.grammar().after(state, token);
      PrefixState next = state;  // the choice is seen after what is forced
      while (const auto t = model.language.grammar().forced(next)) next = model.language.grammar().after(next, *t);
      if (!forced) choice = choice_after(next, choice, token);
    }
    return std::exp(log_probability);
  }

  LinearModel model{few_propositions};
  SentenceFeatures features;
};

TEST_F(Decoding, ProbabilitiesOfAllProgramsSumToOne) {
  Scorer scorer(model, features);
  const auto all = best_programs(scorer, 10'000'000, 2'000'000);
  double total = 0;
  for (const Candidate& candidate : all) total += std::exp(candidate.log_probability);
  EXPECT_NEAR(total, 1.0, 0.03) << all.size();  // programs below e⁻¹² are not made
  EXPECT_LE(total, 1.0 + 1e-4);
}

TEST_F(Decoding, BestFirstGivesTheBestProgramsInOrder) {
  Scorer scorer(model, features);
  const auto all = best_programs(scorer, 5'000, 2'000'000);
  const auto best = best_programs(scorer, 50);
  ASSERT_EQ(best.size(), 50U);
  for (std::size_t i = 0; i < best.size(); ++i) {
    EXPECT_EQ(best[i].program, all[i].program);
    if (i > 0) {
      EXPECT_LE(best[i].log_probability, best[i - 1].log_probability);
    }
    EXPECT_NEAR(std::exp(best[i].log_probability), probability(best[i].program), 1e-5)
        << model.language.grammar().show(best[i].program);
    for (const Step& step : best[i].program)
      for (std::uint16_t p : step.literals()) EXPECT_NE(p, 2) << "place_1 is not named";
  }
}

// A scorer that counts the prefixes it is asked about.
struct Counted {
  using Prefix = Scorer::Prefix;
  static constexpr std::size_t at_once = 1;
  auto prefixes() { return scorer.prefixes(); }
  template <class Visit>
  void log_p(std::span<const Prefix* const> batch, Visit visit) {
    expanded += batch.size();
    scorer.log_p(batch, visit);
  }
  Scorer& scorer;
  std::size_t expanded = 0;
};

TEST_F(Decoding, ExpandsAsManyPrefixesAsAllowed) {
  Scorer scorer(model, features);
  for (const std::size_t allowed : {0U, 1U, 2U, 7U, 50U}) {
    Counted counted{scorer};
    best_programs(counted, 5'000, allowed);
    EXPECT_EQ(counted.expanded, allowed);
  }
  Counted counted{scorer};
  const auto best = best_programs(counted, 20);
  Counted again{scorer};
  EXPECT_EQ(best_programs(again, 20, counted.expanded).size(), best.size());
  EXPECT_EQ(again.expanded, counted.expanded) << "no more than what the best programs need";
}

TEST_F(Decoding, NoProgramIsNoGradient) {
  Scorer scorer(model, features);
  TrieScratch scratch;
  EXPECT_EQ(accumulate_gradient(LinearTrie(), scorer, scratch), 0);
  scorer.each_gradient([](std::uint64_t, const float*) { ADD_FAILURE() << "a gradient"; });
}

TEST_F(Decoding, MarginalLikelihoodIsTheSumOverPrograms) {
  const std::vector<std::pair<Program, double>> programs{
      {{{StepKind::Reach, 0, 1, {0}}}, 1.0},
      {{{StepKind::Reach, 0, 2, {0, 1}}}, 0.5},
      {{{StepKind::Forward, 2, 0, {}}, {StepKind::Next, 0, 1, {3}}}, 1.0},
      {{Step{}}, 0.25}};
  LinearTrie trie;
  double sum = 0;
  for (const auto& [program, weight] : programs) {
    EXPECT_TRUE(trie.add(LinearPrefixes(model.language.grammar()), program, weight));
    EXPECT_FALSE(trie.add(LinearPrefixes(model.language.grammar()), program, 0.9));
    sum += weight * probability(program);
  }
  Scorer scorer(model, features);
  TrieScratch scratch;
  EXPECT_NEAR(accumulate_gradient(trie, scorer, scratch), std::log(sum), 1e-5);

  // The gradient against central differences, for every weight of some rows.
  std::map<std::uint64_t, std::vector<float>> gradients;
  scorer.each_gradient([&](std::uint64_t feature, const float* gradient) {
    auto& total = gradients[feature];
    total.resize(model.weights.columns(), 0.0F);
    for (std::size_t c = 0; c < total.size(); ++c) total[c] += gradient[c];
  });
  const auto value = [&] {
    double total = 0;
    for (const auto& [program, weight] : programs) total += weight * probability(program);
    return std::log(total);
  };
  std::vector<std::uint64_t> features_with_rows;
  model.weights.each([&](std::uint64_t feature, std::size_t column, float) {
    if (column == 0) features_with_rows.push_back(feature);
  });
  std::size_t checked = 0;
  for (std::size_t i = 0; i < features_with_rows.size(); i += 3) {
    const WeightRow r = model.weights.find(features_with_rows[i]).value();
    const auto it = gradients.find(features_with_rows[i]);
    for (std::size_t c = 0; c < model.weights.columns(); c += 2) {
      float& weight = model.weights.row(r)[c];
      const float before = weight, h = 0.02F;
      weight = before + h;
      const double up = value();
      weight = before - h;
      const double down = value();
      weight = before;
      const double difference = (up - down) / (2.0 * static_cast<double>(h));
      const double gradient = it == gradients.end() ? 0.0 : static_cast<double>(it->second[c]);
      EXPECT_NEAR(gradient, difference, 2e-3) << "row " << r.index << " column " << c;
      ++checked;
    }
  }
  EXPECT_GT(checked, 100U);
}

}  // namespace
}  // namespace waymark::parser
