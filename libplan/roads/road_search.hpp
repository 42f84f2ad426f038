// Routes of least cost on a road graph to a goal of a finite task, by its hierarchy.
//
// While the automaton waits in a state q, a route passes only nodes whose letters leave q where it is. The product
// falls apart into legs: from the node where q was entered, past such nodes, to a node whose letter leads on. A leg is
// the shortest path in the subgraph without all other nodes, of which the hierarchy knows least costs: up from the
// entries in the order of ranks, through the core by Dijkstra [Dij59], down to the nodes that lead on [DGNW13].
// Legs from all entries of a state are searched for at once. States are taken from the first component of the
// automaton to the last; within a component, entries that became cheaper are searched from again. A letter does not
// count where the entries it leads to could make no other entry cheaper.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "libplan/model/road_graph.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/roads/road_hierarchy.hpp"
#include "libplan/roads/shared_legs.hpp"
#include "libplan/solve/dijkstra.hpp"

namespace waymark::plan {

struct RoadRoute {                   // on the map
  std::vector<std::uint32_t> nodes;  // from the start; consecutive ones have an arc
  std::uint64_t cost = 0;            // the sum of the cheapest such arcs
};
struct RoadAnswer {                // a route, and what it took
  std::optional<RoadRoute> route;  // nullopt: proved that there is none
  SearchStatistics statistics;     // nodes met in all legs; arcs looked at
};
struct RoadSearchOptions {      // of influence on time and memory only
  std::size_t kept_legs = 256;  // of a search: more of them are searched for again where the route needs one
  SharedLegs::Use shared = SharedLegs::Use::WhereFewer;  // of legs between states
  std::stop_token stop = {};                             // ends with nullopt when it is asked for
};

// The hierarchy is one of this map: std::invalid_argument where sizes differ. Of routes of equal cost it is always the
// same one, but not the one of docs/conventions.md 4. A leg takes time for what lies above its ends in the hierarchy,
// and for the part of the core that is nearer than its ends. A plain Dijkstra among the nodes that may be passed takes
// their place where these are fewer than those that lead on, and where nodes without a label may not be passed.
std::optional<RoadAnswer> least_route(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task,
                                      const RoadSearchOptions& options = {});

}  // namespace waymark::plan
