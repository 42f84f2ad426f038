// Many programs as symbols, sharing their prefixes, under an encoder-decoder: log p of each, and the gradient of any
// objective that is a function of these.
//
//   a choice is a node of the trie; choices that the grammar forces are taken with their symbol
//   ∂ objective / ∂ score(node, v) = Σ_{leaves below (node, v)} g − p(v | node) Σ_{leaves below node} g,  g = ∂ objective / ∂ log p(leaf)
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "libparser/model/encoder_decoder.hpp"

namespace waymark::parser {

// What may follow a prefix.
struct ChoiceMask {
  std::vector<Symbol> allowed;
  std::optional<Symbol> forced;  // the only one, when there is just one
};

// Masks of the states that were asked for, made once each. References stay valid as long as the object.
class ChoiceMasks {
 public:
  explicit ChoiceMasks(const TypedPostfix& symbols) : symbols_(&symbols) {}
  const TypedPostfix& symbols() const { return *symbols_; }
  const ChoiceMask& of(const TypedState& state);
  std::size_t size() const { return made_.size(); }

 private:
  const TypedPostfix* symbols_;
  std::unordered_map<std::uint64_t, ChoiceMask> made_;  // by the state
};

// log p of the allowed symbols, from a column of scores; other entries are left alone. log_p: [symbols]
void log_softmax(const neural::ConstView& scores, neural::Index column, const ChoiceMask& mask,
                 const std::vector<bool>& forbidden, float* log_p);

class SymbolTrie {
 public:
  using Index = neural::Index;

  // Weights of a program's reward or prior. False when it was in already; its first weight stays then.
  // Throws as TypedPostfix::symbols_of.
  bool add(const Program& program, double weight, ChoiceMasks& masks, const History& first);
  std::size_t programs() const { return log_weights_.size(); }
  Index choices() const { return static_cast<Index>(nodes_.size()); }
  void append_histories(std::vector<History>& out) const;  // of all choices, in order

  // log p and log weight of each program, from the scores of its choices: columns [at, at + choices()).
  struct Likelihoods {
    std::vector<float> log_p;    // by program
    std::vector<float> symbols;  // by choice and symbol
  };
  Likelihoods likelihoods(const neural::Matrix& scores, Index at, const std::vector<bool>& forbidden) const;
  const std::vector<float>& log_weights() const { return log_weights_; }
  // dscores, the same columns, from ∂ / ∂ log p of each program.
  void backpropagate(const Likelihoods& likelihoods, std::span<const float> gradient, neural::Matrix& dscores,
                     Index at) const;

 private:
  struct Child {
    Symbol symbol;
    std::int32_t to;  // a node, or ~program
  };
  struct Node {
    History history;
    const ChoiceMask* mask;
    std::vector<Child> children;
  };
  std::vector<Node> nodes_;  // parents before children
  std::vector<float> log_weights_;
};

}  // namespace waymark::parser
