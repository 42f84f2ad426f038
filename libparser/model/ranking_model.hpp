// The weights of the reranker and of the start-pose model (rerank/reranker.hpp), which stand beside a word model.
#pragma once
#include "libparser/model/program_language.hpp"
#include "libparser/model/weight_table.hpp"
#include "libparser/model/word_table.hpp"

namespace waymark::parser {

struct RankingModel {
  explicit RankingModel(const ltl::Vocabulary& vocabulary, Dialect dialect = Dialect::Plain)
      : language(vocabulary, dialect) {}

  ProgramLanguage language;         // of the word model
  WordTable words;                  // that features may name
  WeightTable reranker{1};          // (sentence, route) → one score; empty: ends are chosen by probability alone
  WeightTable start_pose_model{1};  // the same, of where a sentence is said; empty: anywhere
};

}  // namespace waymark::parser
