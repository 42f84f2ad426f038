// Least-cost routes of a deterministic model to a goal of a finite task, found forwards without building the product.
//
// Breadth first when all costs are equal: twelve bytes a pair that was met, one bit a pair that could be; on large
// grids within what A* [HNR68] has found to be worth a look (GridBound). Otherwise Boost.Graph's Dijkstra
// (dijkstra.hpp). Where every route passes one cell of a grid, as between waypoints, nothing met before is looked at
// any more. Among least-cost routes of breadth-first search the one whose choices come first (docs/conventions.md 4).
//
// The search of equal costs is our own: bench_search, 1000² cells, two landmarks in order, ms of processor time in one
// run: this 33, Boost.Graph's breadth_first_visit 66, its A* with GridBound 71.
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>

#include "libltl/limits.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/solve/dijkstra.hpp"

namespace waymark::plan {

// The cost that all choices of the model have; nullopt: they differ, or there are none.
template <class Model>
std::optional<double> uniform_cost(const Model& model);

// nullopt: stopped, or more pairs met than the limit. Throws std::invalid_argument for a model that is not
// deterministic.
template <Model M>
std::optional<SearchAnswer> search(const Product<M, TaskTable>& product,
                                   const ltl::Limits& limits = {.states = SIZE_MAX});

// The word of a route: the start's letter, then one for every choice. Throws std::logic_error when a choice does not
// lead where the route says.
template <class Model>
ltl::Trace word_of(const Model& model, const ChoiceRoute& route);

}  // namespace waymark::plan
