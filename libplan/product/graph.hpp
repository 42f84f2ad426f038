// The product 𝓜 ⊗ 𝒜_φ as a Boost.Graph graph: the one header that names its types.
#pragma once
#include <boost/graph/adjacency_list.hpp>

#include "libautomata/finite/dfa.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

struct ProductState {  // the pair is the state's type
  PoseId pose;
  automata::StateId task;
  friend auto operator<=>(const ProductState&, const ProductState&) = default;
};
struct ProductEdge {
  Action action = Action::Forward;
  double cost = 0;
};
using ProductGraph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, ProductState, ProductEdge>;
using ProductVertex = boost::graph_traits<ProductGraph>::vertex_descriptor;

}  // namespace waymark::plan
