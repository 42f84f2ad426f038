// Boolean functions of variables some of which follow from others: of a chain v₁ < v₂ < … of variables, one with the
// forcing value forces it on all later ones. This is how X F<=1 p, X F<=2 p, … are related.
//
// Only assignments that respect the chains count, and functions that agree on these are one node. Two rules make it so.
// Below the branch where v has the forcing value, no later variable of the chain is decided. The node of v is left out
// when its other branch gives the forced branch, once the later variables of the chain have the forcing value: f ∧ g is
// f where f ⇒ g holds by the chains. The argument is that of [Bry86, Thm. 1], with cofactors on respectful assignments.
// Without chains, this is boolean.hpp.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/bdd/computed_table.hpp"
#include "libautomata/bdd/mtbdd.hpp"

namespace waymark::automata {

class ChainedBoolean {
 public:
  using Node = Mtbdd::Node;
  using Chain = std::uint32_t;                                                     // counted from 0
  explicit ChainedBoolean(Mtbdd& diagram) : diagram_(diagram), plain_(diagram) {}  // over the caller's manager

  Chain add_chain(bool forcing);  // without variables yet
  // Appends a variable that no function reads yet, unless it is the first one of the chain. O(1).
  void append(Chain chain, Mtbdd::Variable v);

  static Node constant(bool value) { return Boolean::constant(value); }             // true or false
  Node variable(Mtbdd::Variable v) { return plain_.variable(v); }                   // the function that is v
  Node negate(Node f) { return if_then_else(f, constant(false), constant(true)); }  // ¬f
  Node conjunction(Node f, Node g) {                                                // f ∧ g
    return f < g ? if_then_else(f, g, constant(false)) : if_then_else(g, f, constant(false));
  }
  Node disjunction(Node f, Node g) {  // f ∨ g
    return f < g ? if_then_else(f, constant(true), g) : if_then_else(g, constant(true), f);
  }
  Node iff(Node f, Node g) { return if_then_else(f, g, negate(g)); }  // f ↔ g
  // (f ∧ g) ∨ (¬f ∧ h). O(|f| |g| |h|) steps without chains; with them each may cost the size of a function more.
  Node if_then_else(Node f, Node g, Node h) {
    return chains_.empty() ? plain_.if_then_else(f, g, h) : chained(f, g, h);
  }
  bool implies(Node f, Node g) { return if_then_else(f, g, constant(true)) == constant(true); }  // is f → g valid?

 private:
  static constexpr Chain none = UINT32_MAX;
  static constexpr std::uint32_t choice = 1, forced_later = 2;  // operations of results_
  struct Links {
    bool forcing;
    Mtbdd::Variable last = 0;
  };
  Chain chain_of(Mtbdd::Variable v) const { return v < chain_of_.size() ? chain_of_[v] : none; }
  Node chained(Node f, Node g, Node h);
  Node cofactor(Node f, Mtbdd::Variable v, bool value);
  Node forced(Node f, Chain chain);  // all variables of the chain have the forcing value
  Node make(Mtbdd::Variable v, Node low, Node high);

  Mtbdd& diagram_;
  Boolean plain_;
  std::vector<Links> chains_;
  std::vector<Chain> chain_of_;  // by variable
  ComputedTable results_;
};

}  // namespace waymark::automata
