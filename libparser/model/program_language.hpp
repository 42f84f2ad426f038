// What the programs of a model speak of: its propositions, its tokens, and the parts that tokens share.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libparser/programs/postfix_grammar.hpp"

namespace waymark::parser {

// Columns of a matrix of weights: tokens first, then their parts. The literal ahead_chair has the parts `ahead` and `chair`.
struct Columns {
  explicit Columns(const PostfixGrammar& grammar);
  std::size_t tokens = 0;
  std::uint16_t mention = 0;                    // the column that weighs being mentioned
  std::vector<std::uint16_t> direction, thing;  // of each token: columns ≥ tokens
  std::vector<std::string> parts;               // names of the columns from `tokens` on
  std::size_t size() const { return tokens + parts.size(); }
};

class ProgramLanguage {
 public:
  explicit ProgramLanguage(const ltl::Vocabulary& vocabulary, Dialect dialect = Dialect::Plain);

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }
  const PostfixGrammar& grammar() const { return grammar_; }
  const Columns& columns() const { return columns_; }
  Dialect dialect() const { return grammar_.limits().dialect; }
  // How many steps a program has at most.
  std::size_t steps() const { return static_cast<std::size_t>(grammar_.limits().steps); }

  // Throws ltl::FormatError naming the first difference when the vocabulary is not this language's.
  void check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const;

 private:
  ltl::Vocabulary vocabulary_;
  PostfixGrammar grammar_;
  Columns columns_;
};

}  // namespace waymark::parser
