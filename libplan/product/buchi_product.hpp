// The product of a deterministic model with a generalised Büchi automaton, stored with marks on its edges.
//
// The model is deterministic, so the planner chooses the run of the automaton. Only here in libplan may an automaton be
// nondeterministic. The product is built in full, 32 bytes an edge, because lassos are searched for in whole
// components.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/product/product.hpp"

namespace waymark::plan {

class BuchiTask {  // any generalised Büchi automaton; it must outlive the object
 public:
  // Propositions that the model does not know never hold.
  BuchiTask(const automata::Automaton& automaton, const Letters& letters)
      : automaton_(&automaton),
        classes_(letters, automaton.vocabulary(), automaton.reads(), UnknownProposition::NeverHolds) {}

  // What the concept of a task (task.hpp) asks.
  std::size_t states() const { return automaton_->states(); }
  std::array<std::uint32_t, 1> initial_states() const { return {automaton_->initial().index}; }
  static bool is_goal(std::uint32_t) { return false; }
  static bool is_over(std::uint32_t) { return false; }
  std::span<const automata::Branch> steps(std::uint32_t q, LetterId letter) const {
    return automaton_->next(automata::StateId{q}, classes_.representatives()[classes_.of(letter)]);
  }
  static std::span<const std::uint32_t> jumps(std::uint32_t) { return {}; }

 private:
  const automata::Automaton* automaton_;
  AlphabetClasses classes_;
};
static_assert(Task<BuchiTask>);

struct MarkedEdge {                // of the product
  std::uint32_t from = 0, to = 0;  // vertices
  std::uint32_t choice = 0;        // of the model
  automata::Marks marks;           // of the automaton
  double cost = 0;                 // of the action
};

struct MarkedGraph {                  // edges by their sources
  std::uint32_t sets = 0;             // an infinite run is accepted when it meets each of so many marks again and again
  std::vector<std::uint32_t> first;   // by vertex, one more for the end
  std::vector<MarkedEdge> edges;      // by source
  std::vector<std::uint32_t> starts;  // where a run may begin

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(first.size()) - 1; }  // numbered from 0
  automata::Marks all() const { return automata::Marks::first(sets); }                     // every mark
};

struct BuchiProduct {
  MarkedGraph graph;                 // of the pairs
  std::vector<ProductState> states;  // by vertex
};

// The reachable part, breadth first from the start, whose letter is read. One state of budget a vertex; throws what the
// budget throws, and std::invalid_argument for a model that is not deterministic or another acceptance condition.
template <Model M>
BuchiProduct compose(const M& model, const automata::Automaton& automaton, automata::Budget& budget);

}  // namespace waymark::plan
