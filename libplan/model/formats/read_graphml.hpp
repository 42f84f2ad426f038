// Graphs in GraphML (FILE.graphml) as models: http://graphml.graphdrawing.org/specification.html.
//
// Nodes are states; a node whose data `name`, `label` or `landmark` has a name is a landmark. Edges are roads; their
// data `length`, `metres`, `weight` or `cost`, the first that there is, is their cost, 1 without. Directed and
// undirected edges are read; hyperedges and graphs in graphs are refused.
#pragma once
#include <string_view>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// States are called by the ids of nodes; docs/formats/planning-cases.md. At most 1 GiB. Throws ltl::FormatError with
// the line.
Mdp parse_graphml(std::string_view xml, std::string_view source = "", std::string_view start = "");

}  // namespace waymark::plan
