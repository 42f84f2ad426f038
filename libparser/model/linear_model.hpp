// A log-linear autoregressive model of programs given a sentence: p(z | x) = Π p(token | prefix, x).
//
// The score of a token is a sum of weights, one row per feature of (sentence, prefix), one column per token *and* per
// part of a token: the literal ahead_chair is scored by its own column, by `ahead` and by `chair`, so that what is
// learned about chairs in front helps with chairs on the left. What the features are: features.hpp. A feature is 64
// bits, a template and its arguments; words are numbered by the model's word table.
// Weights file: model_file.hpp.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "libparser/model/weight_table.hpp"
#include "libparser/programs/postfix_grammar.hpp"

namespace waymark::parser {

// Columns of the weight matrix: tokens first, then their parts.
struct Columns {
  explicit Columns(const PostfixGrammar& grammar);
  std::size_t tokens = 0;
  std::uint16_t mention = 0;                    // the column that weighs being mentioned
  std::vector<std::uint16_t> direction, thing;  // of each token: columns ≥ tokens
  std::vector<std::string> parts;               // names of the columns from `tokens` on
  std::size_t size() const { return tokens + parts.size(); }
};

class WordTable {
 public:
  static constexpr std::uint32_t unknown = 0, begin = 1, end = 2;  // of a sentence; ordinary words from 3 on
  WordTable();
  std::uint32_t find(std::string_view word) const;  // `unknown` when it is not in the table
  std::uint32_t add(std::string_view word);
  const std::vector<std::string>& words() const { return words_; }

 private:
  std::vector<std::string> words_;
  std::unordered_map<std::string, std::uint32_t> index_;
};

class LinearModel {
 public:
  explicit LinearModel(const ltl::Vocabulary& vocabulary, Dialect dialect = Dialect::Plain);

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }
  const PostfixGrammar& grammar() const { return grammar_; }
  Dialect dialect() const { return grammar_.limits().dialect; }
  const Columns& columns() const { return columns_; }
  WordTable words;
  WeightTable reader;    // (sentence, prefix) → a score for every token
  WeightTable reranker;  // (sentence, route) → one score; empty: ends are chosen by probability alone
  WeightTable start_pose_model;  // the same, of where a sentence is said: reranker.hpp; empty: anywhere

  // Throws ltl::FormatError naming the first difference when the vocabulary is not this model's.
  void check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const;

 private:
  ltl::Vocabulary vocabulary_;
  PostfixGrammar grammar_;
  Columns columns_;
};

// How many steps a program of the model's dialect has at most.
inline std::size_t steps_of(const LinearModel& model) {
  return static_cast<std::size_t>(model.grammar().limits().steps);
}

}  // namespace waymark::parser
