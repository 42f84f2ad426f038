// Least-cost lassos of a deterministic model: a prefix to a cycle that is walked for ever and satisfies the task.
//
// Routes are those of the product with a generalised Büchi automaton [STBR11]: the prefix also does what must be done
// once, and the cycle closes in place and automaton state. Costs are therefore those of the automaton that was given:
// another one of the same language may settle its state earlier or close its cycle sooner. Of a conjunction of G F p
// the automaton of our translation has one state, and the cycle is the shortest closed walk through all of them.
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string_view>
#include <utility>

#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/word.hpp"
#include "libplan/solve/product_search.hpp"

namespace waymark::plan {

// What counts, first thing first. A round is a piece of the cycle that meets every mark: a visit, of patrols.
enum class LassoOrder : std::uint8_t {
  Prefix,  // least prefix, then least cycle
  Cycle,   // least cycle, then least prefix
  Mean     // least cost a round of the cycle, then least prefix
};
std::string_view name(LassoOrder order);  // "prefix", "cycle", "mean"

struct LassoRoute {           // a route for ever
  ChoiceRoute prefix, cycle;  // the cycle begins and ends in the last place of the prefix
  std::uint64_t rounds = 1;   // that walking the cycle again and again completes each time; 1 but for Mean
  double mean() const { return cycle.cost / static_cast<double>(rounds); }  // of a round
};
struct LassoAnswer {                // a lasso, or a proof that there is none
  std::optional<LassoRoute> route;  // nullopt: proved that there is none
  SearchStatistics statistics;      // vertices and edges of the product
};

// nullopt: stopped, or more vertices than the limit; (vertex, set of marks) count. Throws std::invalid_argument for a
// model that is not deterministic and an automaton that is not generalised Büchi.
template <class Model>
std::optional<LassoAnswer> least_lasso(const Model& model, const automata::Automaton& automaton, LassoOrder order,
                                       const ltl::Limits& limits = {.states = 100'000'000});

// The letters of the prefix and of the cycle.
template <class Model>
ltl::Lasso word_of(const Model& model, const LassoRoute& route);

// A lasso that was checked: its steps are steps of the model, its cycle closes, its word ⊨ φ by definition, or is
// accepted by an automaton that is taken at its word. The only way to get one is certify; what prints or draws a lasso
// takes this type.
class CertifiedLasso {
 public:
  const LassoRoute& route() const { return route_; }     // as it was checked
  bool by_definition() const { return by_definition_; }  // else by the automaton

 private:
  template <class Model>
  friend CertifiedLasso certify(LassoRoute route, const Model& model, ltl::Formula f);
  template <class Model>
  friend CertifiedLasso certify(LassoRoute route, const Model& model, const automata::Automaton& automaton);
  CertifiedLasso(LassoRoute route, bool by_definition) : route_(std::move(route)), by_definition_(by_definition) {}
  LassoRoute route_;
  bool by_definition_;
};
// Throw std::logic_error (we are wrong). O(|DAG| · |route|²) and O(|route| · branches).
// NOLINTBEGIN(readability-redundant-declaration): friends are declared for all
template <class Model>
CertifiedLasso certify(LassoRoute route, const Model& model, ltl::Formula f);
template <class Model>
CertifiedLasso certify(LassoRoute route, const Model& model, const automata::Automaton& automaton);
// NOLINTEND(readability-redundant-declaration)

}  // namespace waymark::plan
