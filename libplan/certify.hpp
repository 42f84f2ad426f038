// The proof that a route does what was asked: by the definition of ⊨, never by the automaton that found it.
#pragma once
#include <utility>

#include "libltl/formula.hpp"
#include "libplan/solve/route.hpp"

namespace waymark::plan {

// A route that was checked: every step is a step of the map, the cost is the sum of the steps, the word ⊨ φ.
// The only way to get one is certify; whatever prints or draws a route takes this type.
class CertifiedRoute {
 public:
  const Route& route() const { return route_; }      // as it was checked
  ltl::Formula formula() const { return formula_; }  // that the word of the route satisfies

 private:
  friend CertifiedRoute certify(Route route, const Map& map, ltl::Formula f);
  CertifiedRoute(Route route, ltl::Formula f) : route_(std::move(route)), formula_(f) {}
  Route route_;
  ltl::Formula formula_;
};

// Throws std::logic_error (we are wrong) naming the step or the formula when the check fails. The formula's
// propositions are matched with the map's by name. O(|DAG| · |route|²).
CertifiedRoute certify(Route route, const Map& map, ltl::Formula f);

// The same where the task came as an automaton and there is no formula: the steps, the cost, and a run of the automaton
// on the word, letter by letter on its own vocabulary. Weaker than certify: the automaton itself is taken at its word.
class AcceptedRoute {
 public:
  const Route& route() const { return route_; }  // as it was checked

 private:
  friend AcceptedRoute certify_acceptance(Route route, const Map& map, const automata::Dfa& dfa);
  explicit AcceptedRoute(Route route) : route_(std::move(route)) {}
  Route route_;
};
// Throws std::logic_error as certify does.
AcceptedRoute certify_acceptance(Route route, const Map& map, const automata::Dfa& dfa);

}  // namespace waymark::plan
