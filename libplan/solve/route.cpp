#include "libplan/solve/route.hpp"

#include <stdexcept>

namespace waymark::plan {

Route priced(Trajectory trajectory, const Map& map) {
  Route route{std::move(trajectory), 0};
  for (Action action : route.actions) route.cost += map.cost(action);
  return route;
}

Route roll_out(const Product& product, const Policy& policy) {
  Trajectory trajectory{{product.graph[policy.start].pose}, {}};
  ProductVertex at = policy.start;
  while (const std::optional<Action> action = policy.action.at(at)) {
    const auto [begin, end] = out_edges(at, product.graph);
    auto edge = begin;
    while (edge != end && product.graph[*edge].action != *action) ++edge;
    if (edge == end) throw std::logic_error("the policy takes an action that the product does not have");
    if (trajectory.actions.size() >= num_vertices(product.graph))
      throw std::logic_error("the policy runs in a circle");
    at = target(*edge, product.graph);
    trajectory.actions.push_back(*action);
    trajectory.poses.push_back(product.graph[at].pose);
  }
  return priced(std::move(trajectory), *product.map);
}

std::string no_run(const automata::Dfa& dfa, std::size_t pairs) {
  if (dfa.is_trap(dfa.initial())) return "no finite word satisfies the task";
  return "no route from here satisfies the task (all " + std::to_string(pairs) +
         " reachable pairs of pose and state were searched)";
}

}  // namespace waymark::plan
