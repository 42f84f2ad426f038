// A log-linear autoregressive model of programs given a sentence: p(z | x) = Π p(token | prefix, x).
//
// The score of a token is a sum of weights, one row per feature of (sentence, prefix), one column per token *and* per
// part of a token: the literal ahead_chair is scored by its own column, by `ahead` and by `chair`, so that what is
// learned about chairs in front helps with chairs on the left. What the features are: features.hpp. A feature is 64
// bits, a template and its arguments; words are numbered by the model's word table. Scores: scorer.hpp.
#pragma once
#include <cstdint>
#include <memory>

#include "libparser/model/program_language.hpp"
#include "libparser/model/weight_table.hpp"
#include "libparser/model/word_table.hpp"

namespace waymark::parser {

struct RankingModel;
class WeightsReader;
class WeightsWriter;

struct LinearModel {
  static constexpr std::uint16_t file_kind = 1;  // in the header of a model file
  explicit LinearModel(const ProgramLanguage& programs) : language(programs), weights(language.columns().size()) {}
  explicit LinearModel(const ltl::Vocabulary& vocabulary, Dialect dialect = Dialect::Plain)
      : LinearModel(ProgramLanguage(vocabulary, dialect)) {}
  // The words are those of the ranking model, which the file holds once.
  static std::shared_ptr<const LinearModel> read(WeightsReader& in, const RankingModel& ranking);
  void write(WeightsWriter& out, double threshold) const;

  ProgramLanguage language;  // of its programs
  WordTable words;           // that it knows
  WeightTable weights;       // (sentence, prefix) → a score for every token
};

}  // namespace waymark::parser
