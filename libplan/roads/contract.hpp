// Building a hierarchy of roads: which nodes are contracted, in which order, and which shortcuts are needed.
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>

#include "libplan/model/road_graph.hpp"
#include "libplan/roads/road_hierarchy.hpp"

namespace waymark::plan {

struct ContractionOptions {  // what is contracted, and how hard witnesses are searched for
  // Nodes with four arcs at most alone, in rounds and without a search: what 10⁷ nodes take seconds for. The rest is
  // the core.
  bool quick = false;
  std::uint32_t rare = 16;             // letters of no more nodes than this stay in the core,
  std::uint32_t most_rare = 256;       // as long as these are no more nodes in all
  std::uint32_t settled = 300;         // by a search for a witness when a node is contracted,
  std::uint32_t settled_to_rank = 30;  // and when its priority is looked at
  std::uint32_t most_degree = 400;     // a node with more arcs, and all that would follow it, stays in the core
  std::stop_token stop = {};           // ends with nullopt when it is asked for
};

// Least costs of the map in every subgraph from which the nodes of some letters are taken, whatever the options; they
// decide about time and size alone. First rounds of nodes with two neighbours at most, no two of them neighbours; then
// by the shortcuts that a node needs for each arc that it had, and by the longest chain of contracted nodes below it.
// Searches for witnesses give up early, which costs shortcuts that are not needed. Throws std::invalid_argument where
// costs add up to 2^32, or where shortcuts are more than can be stored.
std::optional<RoadHierarchy> contract(const RoadGraph& graph, const ContractionOptions& options = {});

}  // namespace waymark::plan
