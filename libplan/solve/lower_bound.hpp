// A lower bound on the cost from a pair (pose, state) to acceptance: the heuristic of A*.
//
// To get anywhere the task must leave its state q by some action, and from the state q' it then reaches the automaton
// still needs d(q') letters, each of them an action of cost at least c. So with the moves that leave q,
//
//   h(p, q) = 0                                          when q accepts
//   h(p, q) = min over moves u –a→ v with q' = δ(q, L(v, a)), q' ≠ q, q' no trap:  cost(p ⇝ u) + cost(a) + c · d(q')
//
// where p ⇝ u is a cheapest way on the map: one Dijkstra search on the map per state, many sources, done when the
// state is first asked about. It joins the two bounds one would take apart (letters left, way to the next useful
// place) and is at least as large as either.
// Admissible: an accepting route from (p, q) leaves q first by some such move. Consistent: an action that stays in q
// leads p to p', and cost(p ⇝ u) ≤ cost + cost(p' ⇝ u); one that leaves q is among the moves, and h(p', q') ≥ c ·
// d(q').
#pragma once
#include <vector>

#include "libplan/product/product.hpp"
#include "libplan/product/task_steps.hpp"

namespace waymark::plan {

class LowerBound {  // not for two threads at once
 public:
  explicit LowerBound(const TaskSteps& steps);   // steps must outlive the object
  double operator()(const ProductState& state);  // infinity: proved that nothing accepting is reachable

 private:
  std::vector<double> by_pose(automata::StateId q);

  const TaskSteps* steps_;
  double cheapest_action_;
  std::vector<std::vector<double>> bounds_;  // by state, empty until asked about; by pose
};

}  // namespace waymark::plan
