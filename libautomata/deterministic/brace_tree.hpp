// The macro-states of determinize(), and the successor of a macro-state on one letter.
//
// A macro-state is the set of states that the runs of a nondeterministic automaton have reached. Nested braces group
// these states, as the nodes of a Safra tree do: `parent` is the tree, and a state with a brace lies in its innermost
// brace and in all braces around that one.
#pragma once
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

using Brace = std::int32_t;     // number by age, the oldest is 0
constexpr Brace no_brace = -1;  // the run is in no brace

struct BraceTree {
  std::vector<std::pair<std::uint32_t, Brace>> runs;  // state, innermost brace; by state
  std::vector<Brace> parent;                          // of a brace; older than it
  friend auto operator<=>(const BraceTree&, const BraceTree&) = default;
};

struct BraceStep {       // what one letter does to a macro-state
  BraceTree tree;        // the successor
  std::uint32_t colour;  // min even; `nothing` when no brace of the predecessor accepted or was removed
  static constexpr std::uint32_t nothing = UINT32_MAX;  // no colour
};

// The successor function, with the data that does not change while an automaton is determinised.
class BraceRules {
 public:
  // The automaton is a Büchi automaton with marks on edges. above[q][r]: r simulates q.
  BraceRules(const TransitionRelation& automaton, std::vector<std::vector<bool>> above);

  BraceTree initial() const;  // of the initial state alone
  // choices[i]: what the letter offers to tree.runs[i].
  BraceStep successor(const BraceTree& tree, std::span<const std::uint32_t> choices) const;

 private:
  using Places = std::map<std::uint32_t, Brace>;
  std::uint32_t component(std::uint32_t q) const { return live_.components.of[q]; }
  bool accepting(std::uint32_t q) const { return live_.accepting[component(q)]; }
  void prune(Places& places, const std::vector<Brace>& parent) const;

  const TransitionRelation& automaton_;
  LiveComponents live_;
  std::vector<bool> deterministic_;  // by component: inside it no choice has two branches
  std::vector<std::vector<bool>> above_;
};

}  // namespace waymark::automata
