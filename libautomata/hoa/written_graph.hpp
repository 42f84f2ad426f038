// The strongly connected components of an automaton as written, without edges whose label is f.
//
// A universal branch is an edge to each of its targets. The marks of an edge are those of its state and its own.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "libautomata/hoa/syntax.hpp"

namespace waymark::automata {

class HoaGraph {
 public:
  struct Component {                        // states that reach each other
    std::vector<std::uint64_t> states;      // by number in the file
    std::vector<std::uint32_t> successors;  // other components, all of smaller index; may repeat
    bool cyclic = false;                    // some edge stays inside
    bool uniform = true;                    // all edges that stay inside have the same marks …
    std::uint64_t marks = 0;                // … these, of the sets 0 … 63
  };

  explicit HoaGraph(const HoaAutomaton& automaton);                         // O(|body|)
  const std::vector<Component>& components() const { return components_; }  // in topological order, targets first
  // Of a state that occurs in the file.
  std::uint32_t component_of(std::uint64_t number) const { return of_.at(number); }

 private:
  void find_components(const HoaAutomaton& automaton);
  void describe(const HoaAutomaton& automaton);

  std::unordered_map<std::uint64_t, std::uint32_t> of_;
  std::vector<Component> components_;
};

}  // namespace waymark::automata
