// Boolean functions as decision diagrams with terminals 0 (false) and 1 (true), over a manager that the caller owns.
#pragma once
#include <array>
#include <optional>

#include "libautomata/bdd/mtbdd.hpp"

namespace waymark::automata {

class Boolean {
 public:
  using Node = Mtbdd::Node;
  explicit Boolean(Mtbdd& diagram) : diagram_(diagram), ite_(diagram.operation()) {}

  static Node constant(bool value) { return Mtbdd::terminal(value ? 1 : 0); }  // true or false
  // The function that is v.
  Node variable(Mtbdd::Variable v) { return diagram_.make(v, constant(false), constant(true)); }
  Node negate(Node f) { return if_then_else(f, constant(false), constant(true)); }  // ¬f
  Node conjunction(Node f, Node g) {                                                // f ∧ g
    return f < g ? if_then_else(f, g, constant(false)) : if_then_else(g, f, constant(false));
  }
  Node disjunction(Node f, Node g) {  // f ∨ g
    return f < g ? if_then_else(f, constant(true), g) : if_then_else(g, constant(true), f);
  }
  Node iff(Node f, Node g) { return if_then_else(f, g, negate(g)); }  // f ↔ g
  Node if_then_else(Node f, Node g, Node h) {                         // (f ∧ g) ∨ (¬f ∧ h)
    const auto decide = [](const std::array<Node, 3>& a) -> std::optional<Node> {
      if (Mtbdd::is_terminal(a[0])) return a[0] == constant(true) ? a[1] : a[2];
      if (a[1] == a[2]) return a[1];
      if (a[1] == constant(true) && a[2] == constant(false)) return a[0];
      return std::nullopt;
    };
    return diagram_.apply(ite_, std::array{f, g, h}, decide);
  }
  bool implies(Node f, Node g) { return if_then_else(f, g, constant(true)) == constant(true); }  // is f → g valid?

 private:
  Mtbdd& diagram_;
  Mtbdd::Operation ite_;
};

}  // namespace waymark::automata
