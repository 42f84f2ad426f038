#include "libplan/solve/route.hpp"

#include <stdexcept>

namespace waymark::plan {

Route priced(Trajectory trajectory, const Map& map) {
  Route route{std::move(trajectory), 0};
  for (Action action : route.actions) route.cost += map.cost(action);
  return route;
}

Route roll_out(const MapProduct& product, const Policy& policy) {
  Trajectory trajectory{{PoseId{policy.start.place}}, {}};
  ProductState at = policy.start;
  while (const std::optional<Action> action = policy.action.at(product.index(at))) {
    auto [edge, end] = out_edges(at, product);
    while (edge != end && product.action(*edge) != *action) ++edge;
    if (edge == end) throw std::logic_error("the policy takes an action that the product does not have");
    if (trajectory.actions.size() >= num_vertices(product)) throw std::logic_error("the policy runs in a circle");
    at = edge->to;
    trajectory.actions.push_back(*action);
    trajectory.poses.push_back(PoseId{at.place});
  }
  return priced(std::move(trajectory), product.map());
}

std::string no_run(const automata::Dfa& dfa, std::size_t pairs) {
  if (dfa.is_trap(dfa.initial())) return "no finite word satisfies the task";
  return "no route from here satisfies the task (all " + std::to_string(pairs) +
         " reachable pairs of pose and state were searched)";
}

}  // namespace waymark::plan
