// Search and the gradient over a trie of programs, against the list of all programs of a small language.
#include "libparser/decode/grounder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include <cmath>
#include <set>

#include "libparser/decode/explain.hpp"
#include "libparser/decode/network_trie.hpp"
#include "libparser/decode/randomised_beam.hpp"
#include "tests/libparser/model/small_network.hpp"

namespace waymark::parser {
namespace {

TEST(NetworkDecoding, ProbabilitiesOfAllProgramsSumToOne) {
  SmallNetwork small;
  double total = 0;
  for (const auto& [program, log_p] : small.all()) total += std::exp(log_p);
  EXPECT_NEAR(total, 1, 1e-5);
}

TEST(NetworkDecoding, BestFirstIsTheSortedList) {
  SmallNetwork small;
  const auto all = small.all();
  ChoiceMasks masks(small.network.symbols());
  NetworkScorer scorer(small.network, small.sentence, masks);
  const auto best = best_programs(scorer, 30);
  ASSERT_EQ(best.size(), 30U);
  std::vector<double> sorted;
  for (const auto& [program, log_p] : all) sorted.push_back(log_p);
  std::sort(sorted.rbegin(), sorted.rend());
  for (std::size_t i = 0; i < best.size(); ++i) {
    EXPECT_NEAR(best[i].log_probability, sorted[i], 1e-4) << i;
    EXPECT_NEAR(best[i].log_probability, all.at(best[i].program), 1e-4) << small.grammar.show(best[i].program);
  }
}

// What was read before, and in which thread, makes no difference.
TEST(NetworkDecoding, AReaderReadsTheSameAgainAndInSeveralThreads) {
  const SmallNetwork small;
  const WordModel model = std::make_shared<const NetworkModel>(small.network);
  std::vector<SentenceInput> inputs;
  for (const char* text : {"walk to the chair and turn left", "left", "walk", "to place 1", "chair left chair"})
    for (const bool unknown : {false, true}) inputs.push_back({tokenize(text), unknown});
  const auto read = [&](const SentenceInput& input) {
    std::vector<std::pair<Program, double>> out;
    for (const Candidate& c : parser::read(model, input, 20)) out.emplace_back(c.program, c.log_probability);
    return out;
  };
  std::vector<std::vector<std::pair<Program, double>>> fresh;
  for (const SentenceInput& input : inputs) {
    ChoiceMasks masks(small.network.symbols());
    auto& programs = fresh.emplace_back();
    const NetworkSentence sentence = small.network.sentence(input);
    NetworkScorer scorer(small.network, sentence, masks);
    for (const Candidate& c : best_programs(scorer, 20)) programs.emplace_back(c.program, c.log_probability);
    EXPECT_EQ(programs.size(), 20U);
  }
  EXPECT_NE(fresh.front(), fresh.back());
  std::array<bool, 4> same{};
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < same.size(); ++t)
      threads.emplace_back([&, t] {
        same[t] = true;
        for (std::size_t i = 0; i < 3 * inputs.size(); ++i) {
          const std::size_t k = (i * (2 * t + 1) + t) % inputs.size();
          same[t] = same[t] && read(inputs[k]) == fresh[k];
        }
      });
  }
  EXPECT_EQ(same, (std::array<bool, 4>{true, true, true, true}));
}

TEST(NetworkDecoding, AWideBeamFindsEverythingAndANarrowOneWhatIsLikely) {
  SmallNetwork small;
  const auto all = small.all();
  ChoiceMasks masks(small.network.symbols());
  EncoderDecoder::Pass pass;
  const NetworkSentence* const only = &small.sentence;
  pass.encode(small.network, small.network.parameters(), {&only, 1});
  const auto found = randomised_beam(small.network, pass, {&only, 1}, masks, all.size(), 0, small.random).front();
  EXPECT_EQ(found.size(), all.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].log_probability, all.at(found[i].program), 1e-4);
    if (i > 0) {
      EXPECT_LE(found[i].log_probability, found[i - 1].log_probability);
    }
  }
  const NetworkSentence* const twice[] = {only, only};
  pass.encode(small.network, small.network.parameters(), twice);
  const auto pair = randomised_beam(small.network, pass, twice, masks, 5, 0, small.random);
  ASSERT_EQ(pair.size(), 2U);
  EXPECT_EQ(pair[0].size(), pair[1].size());
  for (std::size_t i = 0; i < std::min(pair[0].size(), pair[1].size()); ++i)
    EXPECT_EQ(pair[0][i].program, pair[1][i].program);
  pass.encode(small.network, small.network.parameters(), {&only, 1});
  // With ε = 1 nothing depends on probabilities, and after many draws nothing is left unseen.
  std::set<Program> seen;
  for (int i = 0; i < 2000; ++i) {
    const auto drawn = randomised_beam(small.network, pass, {&only, 1}, masks, 2, 1, small.random);
    EXPECT_LE(drawn.front().size(), 2U);
    for (const Candidate& c : drawn.front()) seen.insert(c.program);
  }
  EXPECT_GT(seen.size(), 2 * all.size() / 3);
}

TEST(NetworkDecoding, AnExplanationMultipliesToTheProbability) {
  SmallNetwork small;
  const SentenceInput input{tokenize("walk to the chair and turn left"), false};
  for (const auto& [program, log_p] : small.all()) {
    double product = 1;
    for (const ExplainedSymbol& symbol : explain(small.network, input, program)) {
      product *= symbol.probability;
      if (symbol.weights.empty()) {
        EXPECT_EQ(symbol.probability, 1);
        continue;
      }
      ASSERT_EQ(symbol.weights.size(), input.tokens.size());
      double total = 0;
      for (const double weight : symbol.weights) {
        EXPECT_GT(weight, 0);
        total += weight;
      }
      EXPECT_LT(total, 1);  // the rest lies on the word before the first
    }
    EXPECT_NEAR(product, std::exp(log_p), 1e-4 * std::exp(log_p) + 1e-7) << small.grammar.show(program);
  }
}

class Trie : public ::testing::Test {
 protected:
  Trie() {
    for (const auto& [program, log_p] : small.all()) programs.push_back(program);
    const NetworkPrefixes prefixes(small.network, masks);
    for (std::size_t i = 0; i < programs.size(); i += 3) {
      EXPECT_TRUE(trie.add(prefixes, programs[i], 0.5));
      EXPECT_FALSE(trie.add(prefixes, programs[i], 1));
      in.push_back(programs[i]);
    }
  }
  neural::Matrix scores() {
    const NetworkSentence* const only = &small.sentence;
    pass.encode(small.network, small.network.parameters(), {&only, 1});
    std::vector<History> histories;
    append_histories(trie, histories);
    const neural::Index begin[] = {0, static_cast<neural::Index>(histories.size())};
    return pass.decode(begin, histories);
  }

  SmallNetwork small;
  ChoiceMasks masks{small.network.symbols()};
  EncoderDecoder::Pass pass;
  NetworkTrie trie;
  std::vector<Program> programs, in;
};

TEST_F(Trie, KnowsTheProbabilityOfEachProgram) {
  const auto all = small.all();
  const Likelihoods found = likelihoods(trie, scores(), 0, small.sentence.forbidden);
  ASSERT_EQ(trie.programs(), in.size());
  EXPECT_LT(trie.nodes().size(), 2 * in.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    EXPECT_NEAR(found.log_p[i], all.at(in[i]), 1e-4);
    EXPECT_NEAR(trie.log_weights()[i], std::log(0.5), 1e-6);
  }
}

// Σ g log p for random g, by central differences of every score.
TEST_F(Trie, GradientIsThatOfTheSumOfLogProbabilities) {
  neural::Matrix s = scores();
  std::vector<float> g(in.size());
  for (float& x : g) x = static_cast<float>(2 * small.random.unit() - 1);
  const auto loss = [&] {
    const Likelihoods found = likelihoods(trie, s, 0, small.sentence.forbidden);
    double sum = 0;
    for (std::size_t i = 0; i < g.size(); ++i) sum += static_cast<double>(g[i]) * static_cast<double>(found.log_p[i]);
    return sum;
  };
  neural::Matrix dscores = neural::Matrix::Zero(s.rows(), s.cols());
  backpropagate(trie, likelihoods(trie, s, 0, small.sentence.forbidden), g, dscores, 0);
  constexpr float h = 1.0F / 64;
  for (neural::Index i = 0; i < s.size(); ++i) {
    const float kept = s.data()[i];
    s.data()[i] = kept + h;
    const double above = loss();
    s.data()[i] = kept - h;
    const double below = loss();
    s.data()[i] = kept;
    EXPECT_NEAR(dscores.data()[i], (above - below) / (2 * static_cast<double>(h)), 2e-3) << i;
  }
}

}  // namespace
}  // namespace waymark::parser
