#include "libplan/certify.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "libltl/meaning/semantics.hpp"

namespace waymark::plan {
namespace {

void check_steps(const Route& route, const Map& map) {
  if (route.poses.empty() || route.poses.size() != route.actions.size() + 1)
    throw std::logic_error("certify: a route has one pose more than it has actions");
  double cost = 0;
  for (std::size_t i = 0; i < route.actions.size(); ++i) {
    if (map.successor(route.poses[i], route.actions[i]) != route.poses[i + 1])
      throw std::logic_error("certify: step " + std::to_string(i + 1) + ", " + std::string(name(route.actions[i])) +
                             " from " + show(map.pose(route.poses[i])) + ", is no step of the map");
    cost += map.cost(route.actions[i]);
  }
  if (std::abs(cost - route.cost) > 1e-9 * std::max(1.0, cost))
    throw std::logic_error("certify: the route costs " + std::to_string(cost) + ", not " + std::to_string(route.cost));
}

}  // namespace

CertifiedRoute certify(Route route, const Map& map, ltl::Formula f) {
  check_steps(route, map);
  if (!ltl::holds(word_for(f, route, map), f))
    throw std::logic_error("certify: the route " + show(route, map) + " does not satisfy the formula");
  return CertifiedRoute(std::move(route), f);
}

AcceptedRoute certify_acceptance(Route route, const Map& map, const automata::Dfa& dfa) {
  check_steps(route, map);
  std::vector<std::pair<ltl::Proposition, ltl::Proposition>> matched;  // of the automaton, of the map
  for (ltl::Proposition p : dfa.reads()) {
    const auto ours = map.vocabulary().find(dfa.vocabulary().name(p));
    if (!ours) throw unknown_proposition(map, dfa.vocabulary().name(p));
    matched.emplace_back(p, *ours);
  }
  automata::StateId q = dfa.initial();
  for (const ltl::Letter& letter : word_of(route, map)) {
    ltl::Letter seen;
    for (const auto& [theirs, ours] : matched)
      if (letter.contains(ours)) seen.insert(theirs);
    q = dfa.next(q, seen);
  }
  if (!dfa.is_accepting(q))
    throw std::logic_error("certify: the automaton does not accept the route " + show(route, map));
  return AcceptedRoute(std::move(route));
}

}  // namespace waymark::plan
