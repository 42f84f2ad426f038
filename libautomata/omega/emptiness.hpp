// Which runs can accept: the graph of an automaton without its letters, its components, and emptiness.
//
// Emptiness for any condition by removing Fin marks recursively: a component all of whose marks satisfy the condition
// accepts; otherwise one mark under Fin is either avoided (its edges removed) or met (its Fin is false). [BBD+19]
#pragma once
#include <vector>

#include "libautomata/omega/automaton.hpp"
#include "libautomata/scc.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

// Branches by state, letters forgotten.
class BranchGraph {
 public:
  BranchGraph() = default;
  explicit BranchGraph(const Branching& automaton);
  void add_state() {
    states_.emplace_back();
    targets_.emplace_back();
  }
  void add(std::uint32_t source, Branch branch) {
    states_[source].push_back(branch);
    targets_[source].push_back(branch.target);
  }
  std::size_t size() const { return states_.size(); }
  const std::vector<Branch>& branches(std::uint32_t q) const { return states_[q]; }
  const std::vector<std::uint32_t>& successors(std::uint32_t q) const { return targets_[q]; }

 private:
  std::vector<std::vector<Branch>> states_;
  std::vector<std::vector<std::uint32_t>> targets_;
};

struct LiveComponents {
  Components components;
  std::vector<bool> accepting;  // by component: some run that stays in it accepts
  std::vector<bool> live;       // by state: some run from it accepts
};
LiveComponents live_components(const BranchGraph& graph, const Condition& condition);

bool is_empty(const Branching& automaton);
bool accepts(const Automaton& automaton, const ltl::Lasso& word);  // O(|uv| · branches)

}  // namespace waymark::automata
