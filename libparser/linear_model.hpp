// A log-linear autoregressive model of programs given a sentence: p(z | x) = Π p(token | prefix, x).
//
// The score of a token is a sum of weights, one row per feature of (sentence, prefix), one column per token *and* per
// part of a token: the literal ahead_chair is scored by its own column, by `ahead` and by `chair`, so that what is
// learned about chairs in front helps with chairs on the left. Features: words and word pairs of the sentence, of the
// clause that the open step belongs to, and the last tokens of the prefix (features.hpp).
// Weights file: docs/formats/corpus-and-models.md.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "libparser/postfix_grammar.hpp"

namespace waymark::parser {

// Columns of the weight matrix: tokens first, then their parts.
struct Columns {
  explicit Columns(const PostfixGrammar& grammar);
  std::size_t tokens = 0, all = 0;
  std::vector<std::uint16_t> direction, thing;  // of each token: a column ≥ tokens
  std::vector<std::string> names;               // of the parts, first is column `tokens`
};

// Feature names → dense rows of weights.
class WeightTable {
 public:
  explicit WeightTable(std::size_t columns = 0) : columns_(columns) {}
  static constexpr std::uint32_t absent = UINT32_MAX;

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return names_.size(); }
  std::uint32_t find(std::string_view feature) const;  // `absent` when it has no row
  std::uint32_t add(std::string_view feature);         // a new row is zero
  const std::string& name(std::uint32_t row) const { return names_[row]; }
  std::span<float> row(std::uint32_t r) { return {&weights_[r * columns_], columns_}; }
  std::span<const float> row(std::uint32_t r) const { return {&weights_[r * columns_], columns_}; }

 private:
  std::size_t columns_;
  std::vector<std::string> names_;
  std::vector<float> weights_;
  std::unordered_map<std::string, std::uint32_t> index_;
};

class LinearModel {
 public:
  explicit LinearModel(const ltl::Vocabulary& vocabulary);

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }
  const PostfixGrammar& grammar() const { return grammar_; }
  const Columns& columns() const { return columns_; }
  WeightTable& reader() { return reader_; }  // sentence → program
  const WeightTable& reader() const { return reader_; }
  WeightTable& chooser() { return chooser_; }  // (sentence, route) → score; may be empty
  const WeightTable& chooser() const { return chooser_; }

  // Throws ltl::FormatError naming both when the vocabulary is not this model's.
  void check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const;

 private:
  ltl::Vocabulary vocabulary_;
  PostfixGrammar grammar_;
  Columns columns_;
  WeightTable reader_, chooser_;
};

// One portable binary file, little endian, checksummed; small weights are dropped, the rest kept as float16.
// Written to a temporary name and renamed. Throws ltl::FormatError when the file cannot be written.
void save(const LinearModel& model, const std::filesystem::path& file);
// Throws ltl::FormatError when it is no weights file, of another version, cut short or altered.
LinearModel load_linear_model(const std::filesystem::path& file);
std::string serialize(const LinearModel& model);
LinearModel parse_linear_model(std::string_view bytes, std::string_view source = "");

}  // namespace waymark::parser
