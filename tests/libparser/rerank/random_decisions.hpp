// What tests of choosing share: sentences of any words, a reader that reads random programs, and models with weights
// for whatever features their routes have.
#pragma once
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "libparser/rerank/reranker.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {

inline const std::vector<std::string> random_words{"left", "right", "chair", "blue", "two", "until", "wall", "second"};

inline SentenceInput random_sentence(std::mt19937_64& random) {
  SentenceInput input;
  for (std::size_t n = 1 + random() % 5; n > 0; --n)
    input.tokens.push_back(random_words[random() % random_words.size()]);
  return input;
}

// Random programs that depend on the words alone, as a word model may give them.
inline std::vector<Weighed> random_candidates(const SentenceInput& input, const PostfixGrammar& grammar,
                                              std::size_t beam) {
  std::size_t seed = 1;
  for (const std::string& word : input.tokens) seed = 31 * seed + std::hash<std::string>()(word);
  std::mt19937_64 random(seed);
  std::vector<Weighed> out;
  for (std::size_t i = 0; i < beam; ++i) {
    const double log_probability = -0.05 * static_cast<double>(i);
    out.push_back({random_program(grammar, random), log_probability, log_probability});
  }
  return out;
}

// Gives every feature of the ends of this decision that the table does not have a random weight.
inline void add_weights(const RankingModel& model, const Executor& executor, const SentenceInput& input,
                        plan::PoseId start, const Decision& decision, WeightTable& table, std::mt19937_64& random) {
  RerankerSentence sentence(model, input);
  for (const End& end : decision.ends) sentence.add_end(executor, start, *decision.plans[end.candidate], end.mass);
  std::uniform_real_distribution<float> weight(-0.3F, 0.3F);
  const auto add = [&](std::uint64_t feature) {
    if (!table.find(feature)) *table.row(table.add(feature)) = weight(random);
  };
  for (const auto& bundle : sentence.take().bundles)
    for (const WeightedFeature& feature : bundle) add(feature.key);
}

}  // namespace waymark::parser
