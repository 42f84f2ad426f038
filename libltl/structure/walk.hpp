// Traversal of the subformulas of a formula, to a depth that the caller decides.
#pragma once
#include <algorithm>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// f and what lies below it, each formula once, operands of g only where enter(g): those with great ids first, so
// operators before operands. O(DAG · log DAG).
template <class Enter>
std::vector<Formula> walk(Formula f, const Enter& enter) {
  std::vector<Formula> out, heap;  // the largest id first: operands have smaller ones
  out.reserve(16);                 // enough for most
  heap.reserve(16);
  heap.push_back(f);
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end());
    const Formula g = heap.back();
    heap.pop_back();
    if (!out.empty() && out.back() == g) continue;
    out.push_back(g);
    if (!enter(g)) continue;
    for (Formula operand : g.operands()) {
      heap.push_back(operand);
      std::push_heap(heap.begin(), heap.end());
    }
  }
  return out;
}

// The subformulas for which known(g) does not hold, operands before operators. What lies below a known one is not
// looked at, so that questions about all subformulas of f cost O(DAG · log DAG) together.
template <class Known>
std::vector<Formula> unknown_subformulas(Formula f, const Known& known) {
  std::vector<Formula> out = walk(f, [&](Formula g) { return !known(g); });
  std::erase_if(out, known);
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace waymark::ltl
