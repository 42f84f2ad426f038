// A strategy or a route written with the names of the model, for files and for people.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/markov_chain.hpp"
#include "libplan/solve/product_search.hpp"

namespace waymark::plan {

struct NamedRoute {                          // a route in names
  std::vector<std::string> places, actions;  // names
  double cost = 0;                           // the sum
};
// With the names of the model.
template <class Model>
NamedRoute named(const Model& model, const ChoiceRoute& route) {
  NamedRoute out{{}, {}, route.cost};
  for (std::uint32_t place : route.places) out.places.push_back(model.name(place));
  for (std::size_t i = 0; i < route.choices.size(); ++i)
    out.actions.emplace_back(model.action(route.places[i], route.choices[i]));
  return out;
}

struct Decision {                                       // in one pair of place and task
  static constexpr std::uint32_t no_jump = UINT32_MAX;  // no jump is made
  std::string place;                                    // its name
  std::uint32_t task = 0;                               // the automaton's state, as the automaton numbers it
  std::string action;                                   // empty: a jump of the automaton, which takes no time
  std::uint32_t jump = no_jump;                         // where to
  std::uint32_t state = 0, choice = 0;                  // of the model: the place, and which of its choices
};

// Of every state that the strategy meets and chooses in, in the order in which it meets them; the first is the start.
template <class Model>
std::vector<Decision> decisions(const ProductMdp<Model>& product, const Strategy& strategy) {
  const MarkovChain chain(product, strategy);
  std::vector<Decision> out;
  for (std::uint32_t i = 0; i < chain.states(); ++i) {
    const auto s = product.state(chain.origin(i));
    const std::uint32_t k = strategy.choice[s.index];
    if (k == Strategy::none) continue;
    Decision decision{product.model().name(s.place), product.task().origin(s.task), {}, Decision::no_jump, s.place, k};
    if (product.is_jump(s, k))
      decision.jump = product.task().origin(product.task().jumps(s.task)[k - product.model().choices(s.place)]);
    else
      decision.action = product.model().action(s.place, k);
    out.push_back(std::move(decision));
  }
  return out;
}

// Of the pairs along a route of a deterministic model.
template <class Model>
std::vector<Decision> decisions(const Model& model, const TaskTable& task, const ChoiceRoute& route) {
  std::vector<Decision> out;
  std::uint32_t q = task.next(task.initial_states().front(), model.initial_letter()).target;
  for (std::size_t i = 0; i < route.choices.size(); ++i) {
    const std::uint32_t place = route.places[i], k = route.choices[i];
    out.push_back(
        {model.name(place), task.origin(q), std::string(model.action(place, k)), Decision::no_jump, place, k});
    model.for_each_outcome(place, k, [&](std::uint32_t, LetterId letter, double) { q = task.next(q, letter).target; });
  }
  return out;
}

}  // namespace waymark::plan
