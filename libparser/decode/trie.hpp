// Many programs at once, sharing their prefixes: the marginal likelihood of a set of programs and its gradient.
//
//   value(node) = log Σ_child exp(log p(token | node) + value(child)),   value(leaf) = log weight of the program
// A sentence has a few hundred consistent programs and about as many prefixes; each prefix is scored once.
#pragma once
#include <cstdint>
#include <vector>

#include "libparser/model/scorer.hpp"

namespace waymark::parser {

class ProgramTrie {
 public:
  explicit ProgramTrie(const PostfixGrammar& grammar);

  // Weights multiply probabilities: 1 counts fully. A program that is in already keeps its first weight.
  // Returns whether it was new.
  bool add(const Program& program, double weight);
  std::size_t programs() const { return programs_; }
  std::size_t nodes() const { return nodes_.size(); }

  // Room for one pass; keep it to save allocations.
  struct Scratch {
    std::vector<float> log_p;  // [nodes × tokens]
    std::vector<float> value, mass, delta;
    std::vector<Scorer::GroupIds> groups;
  };
  // log Σ_z weight(z) p(z | x); its gradient goes to the scorer, which must have begun this sentence.
  double accumulate_gradient(Scorer& scorer, Scratch& scratch) const;

 private:
  struct Child {
    Token token;
    std::int32_t node;  // −1: a complete program
    float log_weight;
  };
  struct Node {
    PrefixState state;
    Choice choice;
    std::vector<Child> children;
  };
  void forward(Scorer& scorer, Scratch& scratch) const;

  const PostfixGrammar* grammar_;
  std::vector<Node> nodes_;  // parents before children
  std::size_t programs_ = 0;
};

}  // namespace waymark::parser
