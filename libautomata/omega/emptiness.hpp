// The graph of an automaton without its letters, its components, and emptiness.
//
// Emptiness removes Fin marks recursively. A component whose marks together satisfy the condition accepts. Otherwise
// one mark under Fin is avoided (its edges are removed) or met (its Fin is false). [BBD+19]
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "libautomata/graph/scc.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

// Branches by state, letters forgotten.
class BranchGraph {
 public:
  class Targets {  // of the branches of a state
   public:
    class Iterator {  // over the targets
     public:
      explicit Iterator(const Branch* at) : at_(at) {}
      std::uint32_t operator*() const { return at_->target; }
      Iterator& operator++() {
        ++at_;
        return *this;
      }
      friend bool operator==(Iterator, Iterator) = default;

     private:
      const Branch* at_;
    };
    explicit Targets(std::span<const Branch> branches) : branches_(branches) {}
    std::size_t size() const { return branches_.size(); }
    std::uint32_t operator[](std::size_t i) const { return branches_[i].target; }
    Iterator begin() const { return Iterator(branches_.data()); }
    Iterator end() const { return Iterator(branches_.data() + branches_.size()); }

   private:
    std::span<const Branch> branches_;
  };

  BranchGraph() = default;
  explicit BranchGraph(const TransitionRelation& automaton);
  void add_state() { ++states_; }  // without branches yet
  // O(1) as long as sources ascend, else O(size). The spans given out before are not valid any more.
  void add(std::uint32_t source, Branch branch);
  std::size_t size() const { return states_; }
  std::span<const Branch> branches(std::uint32_t q) const {
    if (q + std::size_t{1} >= begin_.size()) return {};
    return {branches_.data() + begin_[q], begin_[q + 1] - begin_[q]};
  }
  Targets successors(std::uint32_t q) const { return Targets(branches(q)); }

 private:
  std::size_t states_ = 0;
  std::vector<std::size_t> begin_{0};  // up to the last state that has branches, and the end of that one's
  std::vector<Branch> branches_;
};

struct LiveComponents {         // which components accept
  Components components;        // of the graph
  std::vector<bool> accepting;  // by component: some run that stays in it accepts
  std::vector<bool> live;       // by state: some run from it accepts
};
LiveComponents live_components(const BranchGraph& graph, const Condition& condition);  // of all components

bool is_empty(const TransitionRelation& automaton);                // is no word accepted?
bool accepts(const Automaton& automaton, const ltl::Lasso& word);  // O(|uv| · branches)

}  // namespace waymark::automata
