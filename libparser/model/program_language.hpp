// What the programs of a model speak of: its propositions, its tokens, and the parts that tokens share.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libparser/lexicon/lexicon.hpp"
#include "libparser/programs/postfix_grammar.hpp"
#include "libplan/world/observable.hpp"

namespace waymark::parser {

// Columns of a matrix of weights: tokens, then their parts. The literal ahead_chair has the parts `ahead`, `chair`.
struct Columns {
  Columns(const PostfixGrammar& grammar, const std::vector<plan::Observable>& observables);
  std::size_t tokens = 0;                       // how many
  std::uint16_t mention = 0;                    // the column that weighs being mentioned
  std::vector<std::uint16_t> direction, thing;  // of each token: columns ≥ tokens
  std::vector<Part> parts;                      // the columns from `tokens` on
  std::size_t size() const { return tokens + parts.size(); }
  const Part& part(std::uint16_t column) const { return parts[column - tokens]; }  // of a column behind the tokens
};

class ProgramLanguage {
 public:
  // Throws std::invalid_argument when a proposition has no known form (libplan/world/labelling.hpp).
  ProgramLanguage(const ltl::Vocabulary& vocabulary, PostfixGrammar::Limits limits);
  explicit ProgramLanguage(const ltl::Vocabulary& vocabulary, Dialect dialect = Dialect::Plain)
      : ProgramLanguage(vocabulary, PostfixGrammar::limits_of(dialect)) {}

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }                  // of the propositions
  const std::vector<plan::Observable>& observables() const { return observables_; }  // by proposition
  const PostfixGrammar& grammar() const { return grammar_; }                         // of the programs
  const Columns& columns() const { return columns_; }                                // of the weights
  Dialect dialect() const { return grammar_.limits().dialect; }                      // of the programs
  // How many steps a program has at most.
  std::size_t steps() const { return static_cast<std::size_t>(grammar_.limits().steps); }

  // Throws ltl::FormatError naming the first difference when the vocabulary is not this language's.
  void check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const;

 private:
  ltl::Vocabulary vocabulary_;
  std::vector<plan::Observable> observables_;
  PostfixGrammar grammar_;
  Columns columns_;
};

}  // namespace waymark::parser
