// Two diagrams walked together: to which pairs of terminals do letters lead?
#pragma once
#include <algorithm>

#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/budget.hpp"
#include "libltl/rewriting/pair_memo.hpp"

namespace waymark::automata {

class PairWalk {
 public:
  using Node = Mtbdd::Node;
  // Over the same variables; one manager or two.
  PairWalk(const Mtbdd& first, const Mtbdd& second, Budget& budget) : first_(first), second_(second), budget_(budget) {}

  // meet(payload, payload) for each pair of terminals below the roots, once. One step of budget per pair of nodes.
  template <class Meet>
  void from(Node x, Node y, const Meet& meet) {
    seen_.clear();
    visit(x, y, meet);
  }

 private:
  template <class Meet>
  void visit(Node x, Node y, const Meet& meet) {
    if (!seen_.insert(x.id, y.id)) return;
    budget_.step();
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) return meet(Mtbdd::payload(x), Mtbdd::payload(y));
    const Mtbdd::Variable top = std::min(first_.variable(x), second_.variable(y));
    const auto side = [&](const Mtbdd& diagram, Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    for (const bool high : {false, true}) visit(side(first_, x, high), side(second_, y, high), meet);
  }

  const Mtbdd &first_, &second_;
  Budget& budget_;
  ltl::PairMemo<bool> seen_;  // of nodes
};

}  // namespace waymark::automata
