// The product of a deterministic model with a generalised Büchi automaton, as a graph with marks on its edges.
//
// A run of the automaton may choose, and where nothing is left to chance a planner chooses for it: so the automaton may
// be nondeterministic here, and nowhere else in libplan. Built in full, 32 bytes an edge: a lasso is looked for in whole
// components, not on the way to a goal.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct MarkedEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t choice = 0;  // of the model
  automata::Marks marks;
  double cost = 0;
};

struct MarkedGraph {
  std::uint32_t sets = 0;  // an infinite run is accepted when it meets each of so many marks again and again
  std::vector<std::uint32_t> first;   // by vertex, one more for the end
  std::vector<MarkedEdge> edges;      // by source
  std::vector<std::uint32_t> starts;  // where a run may begin

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(first.size()) - 1; }
  std::span<const MarkedEdge> out(std::uint32_t v) const {
    return {edges.data() + first[v], edges.data() + first[v + 1]};
  }
  automata::Marks all() const { return automata::Marks::first(sets); }
};

struct BuchiProduct {
  MarkedGraph graph;
  std::vector<std::uint32_t> places, tasks;  // by vertex
};

// The reachable part, breadth first from the start, whose letter is read. One state of budget a vertex; throws what the
// budget throws, and std::invalid_argument for a model that is not deterministic or another acceptance condition.
template <class Model>
BuchiProduct compose(const Model& model, const automata::Automaton& automaton, automata::Budget& budget);

extern template BuchiProduct compose(const Mdp&, const automata::Automaton&, automata::Budget&);
extern template BuchiProduct compose(const GridWorld&, const automata::Automaton&, automata::Budget&);

}  // namespace waymark::plan
