// φ ⇒ ψ at every position of every word, recognised from the syntax: sound and incomplete.
//
// The relation holds on finite and infinite words (a position is never past the end of a word, so F true is true here).
// After Somenzi and Bloem, Efficient Büchi automata from LTL formulae (CAV 2000), with the weak next added.
#pragma once
#include <cstddef>
#include <functional>
#include <utility>

#include "libltl/formula.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/pair_memo.hpp"
#include "libltl/text/bounds.hpp"

namespace waymark::ltl {

class Implication {
 public:
  // Asked where the rules find nothing: proves φ ⇒ ψ by other means (automata, say), or says no.
  using Oracle = std::function<bool(Formula from, Formula to)>;
  explicit Implication(Oracle oracle = {}) : oracle_(std::move(oracle)) {}

  // Does φ ⇒ ψ follow by the rules? Answers are remembered; formulas nested deeper than `most_depth` in the course
  // of an answer are not looked into ("no"), and after `most_steps` new pairs the answer is "no": formulas of many
  // thousand operators are simplified less, not for ever.
  bool operator()(Formula from, Formula to) {
    if (is_literal(from) && is_literal(to)) return from == to;  // also of thousands of them, pair by pair
    return follows(from, to, most_depth) || (oracle_ && oracle_(from, to));
  }
  static constexpr std::size_t most_depth = 24, most_steps = 1'000'000;
  // ¬φ with negations pushed inwards, so that it can be looked into. Remembered.
  Formula opposite(Formula f) { return opposites_.of(f); }

 private:
  static bool is_literal(Formula f) { return f.op() == Op::Atom || (f.op() == Op::Not && f[0].op() == Op::Atom); }
  bool follows(Formula from, Formula to, std::size_t depth);
  bool by_junctions(Formula from, Formula to, std::size_t depth);
  bool by_temporal(Formula from, Formula to, std::size_t depth);
  bool by_expansion(Formula from, Formula to, std::size_t depth);

  std::size_t steps_ = 0;
  PairMemo<bool> known_;  // by both ids
  Opposites opposites_;
  Bounds bounds_;
  Oracle oracle_;
};

}  // namespace waymark::ltl
