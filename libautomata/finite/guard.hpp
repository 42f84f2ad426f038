// Guards: the condition on a letter that labels an edge, as a disjunction of cubes (conjunctions of literals) from
// which none can be dropped. [Min93]
//
// Inside the library, edges are decision diagrams. Guards are computed only for output.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/finite/dfa.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

struct Literal {
  Mtbdd::Variable variable = 0;  // a position in Dfa::reads()
  bool positive = true;          // or negated
};
using Cube = std::vector<Literal>;  // a conjunction, variables ascending; empty is true
using Guard = std::vector<Cube>;    // a disjunction; empty is false

// A disjunction of cubes equivalent to f, from which no cube and no literal can be dropped. `diagram` contains f and
// receives new nodes.
Guard irredundant_cover(Mtbdd& diagram, Boolean& logic, Mtbdd::Node f);
// The same; nullopt when the cover has more than `most_cubes` cubes. The work is bounded by a multiple of `most_cubes`.
std::optional<Guard> irredundant_cover(Mtbdd& diagram, Boolean& logic, Mtbdd::Node f, std::size_t most_cubes);

struct Edge {              // one arrow of a drawing
  StateId source, target;  // the ends
  Guard guard;             // the letters that take the edge
};

// The edges of one automaton, merged by (source, target), targets in order of first appearance in the diagram.
class Edges {
 public:
  explicit Edges(const Dfa& dfa);  // the DFA must outlive this object
  Edges(const Edges&) = delete;
  Edges& operator=(const Edges&) = delete;
  std::vector<Edge> from(StateId q);  // those that leave q
  // The same; nullopt when a guard has more than `most_cubes` cubes.
  std::optional<std::vector<Edge>> from(StateId q, std::size_t most_cubes);
  // The letters that lead from q to r, negated when that is shorter to write: `otherwise` edges stay readable.
  ltl::Formula label(StateId q, StateId r, ltl::Arena& arena);

 private:
  Mtbdd::Node leads_to(StateId q, StateId r);

  const Dfa& dfa_;
  Mtbdd scratch_;  // the automaton's diagram, and the edges' Boolean ones
  Boolean logic_;
  std::vector<Mtbdd::Operation> is_target_;  // by state: the operation that turns its terminal into true
};

// The states that q leads to in one letter, in order of first appearance in the diagram (false before true).
std::vector<StateId> targets(const Dfa& dfa, StateId q);
// Edges after merging by (source, target): pairs of states with a letter between them. O(states · diagram).
std::size_t count_edges(const Dfa& dfa);
// The same; nullopt as soon as there are more than `most` edges.
std::optional<std::size_t> count_edges(const Dfa& dfa, std::size_t most);
// Decision nodes that the automaton consists of.
std::size_t count_nodes(const Dfa& dfa);

// The guard as a formula over the propositions that the automaton reads, in an arena that knows their names.
ltl::Formula to_formula(const Guard& guard, const Dfa& dfa, ltl::Arena& arena);

}  // namespace waymark::automata
