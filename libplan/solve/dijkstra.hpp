// Routes of least cost in a product whose costs differ: Boost.Graph's Dijkstra [Dij59], run on the implicit product.
//
// Of pairs at equal cost the one that was met first is settled first, so routes do not depend on the heap.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/product/product.hpp"
#include "libplan/product/task_table.hpp"

namespace waymark::plan {

struct ChoiceRoute {                           // places and the choices between them
  std::vector<std::uint32_t> places, choices;  // one place more than choices
  double cost = 0;                             // the sum
};
struct SearchStatistics {            // what a search has looked at
  std::uint64_t met = 0, edges = 0;  // pairs of place and task; edges looked at
};
struct SearchAnswer {                // a route, and what it took
  std::optional<ChoiceRoute> route;  // nullopt: proved that there is none
  SearchStatistics statistics;       // of the search
};

// From one pair to the nearest goal. nullopt: stopped, or more pairs met than the limit.
template <Model M>
std::optional<SearchAnswer> dijkstra(const Product<M, TaskTable>& product, const ProductState& first,
                                     const ltl::Limits& limits);

}  // namespace waymark::plan
