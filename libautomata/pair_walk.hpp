// Two diagrams walked together: to which pairs of terminals do letters lead?
#pragma once
#include <algorithm>
#include <cstdint>
#include <unordered_set>

#include "libautomata/effort.hpp"
#include "libautomata/mtbdd.hpp"

namespace waymark::automata {

class PairWalk {
 public:
  using Node = Mtbdd::Node;
  // Over the same variables; one manager or two.
  PairWalk(const Mtbdd& first, const Mtbdd& second, Effort& effort)
      : first_(first), second_(second), effort_(effort) {}

  // meet(payload, payload) for each pair of terminals below the roots, once. One step of effort per pair of nodes.
  template <class Meet>
  void from(Node x, Node y, const Meet& meet) {
    seen_.clear();
    visit(x, y, meet);
  }

 private:
  template <class Meet>
  void visit(Node x, Node y, const Meet& meet) {
    if (!seen_.insert(std::uint64_t{x.id} << 32U | y.id).second) return;
    effort_.step();
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) return meet(Mtbdd::payload(x), Mtbdd::payload(y));
    const Mtbdd::Variable top = std::min(first_.variable(x), second_.variable(y));
    const auto side = [&](const Mtbdd& diagram, Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    for (const bool high : {false, true}) visit(side(first_, x, high), side(second_, y, high), meet);
  }

  const Mtbdd &first_, &second_;
  Effort& effort_;
  std::unordered_set<std::uint64_t> seen_;  // pairs of nodes
};

}  // namespace waymark::automata
