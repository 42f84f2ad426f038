// Small road graphs with labels, drawn at random, and routes on them by plain Dijkstra over the product.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libplan/model/road_graph.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/roads/contract.hpp"
#include "libplan/solve/product_search.hpp"

namespace waymark::plan::testing {

struct RandomRoads {
  std::uint32_t nodes = 8;
  std::size_t arcs = 16;
  double two_way = 0.7;   // chance that an arc has one back, of the same cost
  double labelled = 0.3;  // chance of each proposition a, b, x at a node
  std::uint32_t most_cost = 5;
};

inline RoadGraph random_roads(ltl::Random& random, const RandomRoads& shape) {
  RoadGraph::Parts parts;
  ltl::Vocabulary names(std::vector<std::string>{"a", "b", "x"});
  parts.letters = Letters(names);
  parts.letters.intern({});
  for (std::uint32_t v = 0; v < shape.nodes; ++v) {
    ltl::Letter letter;
    for (std::uint32_t p = 0; p < 3; ++p)
      if (random.chance(shape.labelled)) letter.insert(ltl::Proposition{p});
    parts.letter.push_back(static_cast<std::uint16_t>(parts.letters.intern(letter).index));
  }
  const auto add = [&](std::size_t u, std::size_t v, std::size_t cost) {
    parts.tails.push_back(static_cast<std::uint32_t>(u));
    parts.arcs.push_back({static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(cost)});
  };
  while (parts.arcs.size() < shape.arcs) {
    const std::size_t u = random.below(shape.nodes), v = random.below(shape.nodes),
                      cost = random.below(shape.most_cost);
    add(u, v, cost);
    if (random.chance(shape.two_way)) add(v, u, cost);
  }
  parts.start = static_cast<std::uint32_t>(random.below(shape.nodes));
  return RoadGraph(std::move(parts));
}

inline std::string show(const RoadGraph& graph) {
  std::string out = "start " + RoadGraph::name(graph.start());
  for (std::uint32_t v = 0; v < graph.nodes(); ++v) {
    out += "\n" + RoadGraph::name(v) + " " + ltl::show(graph.letters()[graph.letter(v)], graph.letters().vocabulary());
    for (const RoadGraph::Arc& arc : graph.arcs(v))
      out += " " + RoadGraph::name(arc.to) + ":" + std::to_string(arc.cost);
  }
  return out + "\n";
}

// The referee: the cost by Dijkstra over the product of the same roads as an Mdp.
inline std::optional<double> least_cost_on_product(const RoadGraph& graph, const TaskTable& task) {
  const Mdp mdp = model_of(graph);
  const auto found = search(Product(mdp, task));
  return found->route ? std::optional(found->route->cost) : std::nullopt;
}

// Ways to build a hierarchy, none of which may change an answer.
inline std::vector<ContractionOptions> all_contractions() {
  ContractionOptions all, quick, core, bits, early;
  quick.quick = true;
  core.rare = 1000;
  core.most_rare = 1000;
  bits.rare = 0;
  early.settled = 2;
  early.rare = 1;
  early.most_degree = 4;
  return {all, quick, core, bits, early};
}

}  // namespace waymark::plan::testing
