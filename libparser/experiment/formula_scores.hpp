// The share of sentences whose formula was read as it was meant.
//
//   same         the two are one formula, node by node
//   equivalent   they have the same finite words: their minimal automata do not differ
// By construct, as the gold program has it, and by length in units (steps with the functions around them).
#pragma once
#include <map>
#include <string>
#include <string_view>

#include "libparser/experiment/evaluate.hpp"

namespace waymark::parser {

struct FormulaShare {        // hits among sentences
  Percent same, equivalent;  // of sentences
};

struct FormulaScores {
  FormulaShare all;                                  // sentences together
  std::map<std::string, FormulaShare> by_construct;  // sequencing, avoidance, until, conditional, counting, single
  std::map<std::size_t, FormulaShare> by_length;     // units of the gold program
};

class FormulaJudge {  // compares with gold formulas
 public:
  FormulaJudge(const ltl::Vocabulary& vocabulary, Dialect dialect);
  ~FormulaJudge();
  FormulaJudge(const FormulaJudge&) = delete;
  FormulaJudge& operator=(const FormulaJudge&) = delete;

  // An empty program: nothing was read. Throws ltl::SyntaxError on a gold formula that is none.
  void judge(std::string_view gold, const Program& read);
  const FormulaScores& scores() const { return scores_; }

 private:
  bool equivalent(ltl::Formula a, ltl::Formula b);
  struct Automata;
  PostfixGrammar grammar_;
  std::unique_ptr<Automata> automata_;  // made once for each formula
  FormulaScores scores_;
};

// Of the predictions to sentences by themselves, of the corpus, that have a formula; sentences go by map and id. Where
// both conventions were asked about, under the absolute one.
FormulaScores formula_scores(const std::vector<Prediction>& predictions, const Corpus& corpus,
                             std::span<const plan::Map> maps, bool absolute);

}  // namespace waymark::parser
