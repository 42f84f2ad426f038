// Routes, and the proof that a route does what was asked: by the definition of ⊨, never by the automaton.
#pragma once
#include <string>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/word.hpp"
#include "libplan/solve/outcome.hpp"

namespace waymark::plan {

struct Route {
  std::vector<PoseId> poses;     // poses.size() = actions.size() + 1
  std::vector<Action> actions;
  double cost = 0;
};

Route roll_out(const Product& product, const Policy& policy);
ltl::Trace word_of(const Route& route, const Map& map);  // L(start), then one letter per action

// A route that was checked: every step is a step of the map, the cost is the sum of the steps, the word ⊨ φ.
// The only way to get one is certify; whatever prints or draws a route takes this type.
class CertifiedRoute {
 public:
  const Route& route() const { return route_; }
  ltl::Formula formula() const { return formula_; }

 private:
  friend CertifiedRoute certify(Route route, const Map& map, ltl::Formula f);
  CertifiedRoute(Route route, ltl::Formula f) : route_(std::move(route)), formula_(f) {}
  Route route_;
  ltl::Formula formula_;
};

// Throws std::logic_error (we are wrong) naming the step or the formula when the check fails. The formula's
// propositions are matched with the map's by name.
CertifiedRoute certify(Route route, const Map& map, ltl::Formula f);

}  // namespace waymark::plan
