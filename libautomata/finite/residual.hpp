// Residuals: what progression leaves of an LTLf formula, as Boolean functions over its elementary formulas.
//
// Elementary formulas are the propositions, X φ and φ U ψ. All others are expressed by them (N φ = ¬X ¬φ, φ R ψ = ¬(¬φ
// U ¬ψ)). A residual is a BDD over elementary formulas, so propositionally equivalent residuals are one node and the
// closure under progression is finite. A leaf of the successor diagram is (residual of a non-empty rest, may the word
// end here):
//   δ(p) = if p then (true, ✓) else (false, ✗)    δ(X φ) = (φ, ✗)    δ(φ U ψ) = δ(ψ) ∨ (δ(φ) ∧ (φ U ψ, ✗)),
// and Boolean operators act on both halves. This is libltl/meaning/progress.hpp for all letters at once. The leaves
// follow [DZP+25, Sec. 3]; states up to propositional equivalence are [EKS16, Sec. 2], here as BDDs of elementary
// formulas. X F<=1 p, X F<=2 p, … are a chain (bdd/chained_boolean.hpp), so F<=i p ∧ F<=j p is F<=i p for i ≤ j, and
// the closure of G(q → F<=k p) has k + 2 residuals, not one for each set of bounds.
#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "libautomata/bdd/chained_boolean.hpp"
#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/bounds.hpp"

namespace waymark::automata {

class Residuals {  // the residuals of one formula
 public:
  using Node = Mtbdd::Node;
  struct Leaf {     // a terminal of a successor
    Node residual;  // of the rest, which is not empty
    bool may_stop;  // the rest may be empty
  };

  // reads[v] is the proposition of variable v of the successor diagrams.
  Residuals(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget);

  std::uint32_t initial() const { return initial_; }                          // the leaf (φ, ✗)
  std::size_t leaves() const { return leaves_.size(); }                       // how many are known
  const Leaf& leaf(std::uint32_t payload) const { return leaves_[payload]; }  // by the payload of a terminal
  // δ(residual of the leaf, ·): payloads are leaves. Intermediate diagrams are collected when they are many; what was
  // returned once stays.
  Node successors(std::uint32_t payload);
  // Leaves below such a diagram that were not listed before, the false side first; the initial one never is.
  std::vector<std::uint32_t> fresh_leaves(Node successors);
  const Mtbdd& diagram() const { return letters_; }
  // What the rest must satisfy, over infinite words: as a formula.
  ltl::Formula formula(Node residual, ltl::Arena& arena);

 private:
  enum class Kind : std::uint8_t { Proposition, Next, Until };
  struct Elementary {
    Kind kind;
    Node left,
        right;  // of an Until; the operand of a Next is right; the variable of a Proposition is right's payload
  };
  static constexpr std::uint32_t trap = 0, anything = 1;  // the leaves (false, ✗) and (true, ✓)

  Node residual_of(ltl::Formula f, const std::vector<ltl::Proposition>& reads);
  Node elementary(Kind kind, Node left, Node right);
  Node next(Node operand, std::optional<ChainedBoolean::Chain> chain = {});
  std::optional<ChainedBoolean::Chain> chain_of(ltl::Formula next, const std::unordered_map<ltl::Formula, Node>& image);
  Node until(Node left, Node right);
  Node progress(Node residual);
  Node progress_elementary(const Elementary& e, Node self);
  std::uint32_t payload(Node residual, bool may_stop);
  std::uint32_t choose(std::uint32_t f, std::uint32_t g,
                       std::uint32_t h);  // if f then g else h, on both halves
  Node if_then_else(Node f, Node g, Node h);
  ltl::Formula spelled(const Elementary& e, ltl::Arena& arena);
  void collect();

  std::vector<ltl::Proposition> reads_;
  Mtbdd residuals_;  // variables are elementary formulas
  ChainedBoolean logic_;
  Mtbdd letters_;  // variables are propositions, payloads are leaves
  Mtbdd::Operation ite_;
  Budget& budget_;
  std::vector<Elementary> elementary_;
  std::vector<Node> elementary_successors_;
  std::unordered_map<std::uint64_t, Mtbdd::Variable> next_, until_;
  ltl::Bounds bounds_;
  struct BoundedNexts {  // X or N of F<=1 φ, F<=2 φ, … or of G<=1 φ, …
    ltl::Op next;
    ltl::Bound first;
    std::size_t steps;  // of the last one
    ChainedBoolean::Chain chain;
  };
  std::unordered_map<std::uint32_t, std::vector<BoundedNexts>> bounded_nexts_;  // by the id of φ
  std::unordered_map<std::uint32_t, Node> progressed_;
  std::unordered_map<std::uint32_t, ltl::Formula> spelled_;
  std::vector<Leaf> leaves_;
  std::unordered_map<std::uint64_t, std::uint32_t> payload_of_;
  std::uint32_t initial_ = 0;
  std::vector<bool> walked_, listed_;  // nodes whose leaves are all listed; leaves
  std::size_t kept_ = 0;               // letters when some were last collected
};

// The leaves that the initial one reaches, as states; `order` receives one leaf of each. Over infinite words "may stop
// here" says nothing: leaves that differ in it alone are one state, and no state accepts.
Transitions close(Residuals& residuals, ltl::Semantics words, std::vector<std::uint32_t>& order, Budget& budget);

}  // namespace waymark::automata
