// What every letter is to the legs that leave a state of a task: passed, an end, both, or closed.
//
// A letter that leaves the state q where it is may be passed, one that leads to another state ends a leg. Some letters
// may do both. Let L(q) be the words with a prefix that leads from q to a goal. A letter l does no harm in q when
// L(q) ⊆ L(δ(q, l)): meeting it early costs nothing, as for places that are wanted in any order. Then a leg may pass
// it as if the task waited in q. Such a leg claims a state p while its word has led to some other state r, but
// L(p) ⊆ L(r) always holds: at first both are the same state; a step by the same letter derives both languages; and
// where l is passed, L(p) ⊆ L(δ(p, l)) ⊆ L(δ(r, l)). A claimed goal has L = every word, so the word has met a goal, at
// the latest there. Every route that is claimed is therefore one of the task, perhaps already at a shorter prefix,
// and every route of the task is still found: passing is a choice. So least costs are the same.
//
// L(q) ⊆ L(q') is the greatest simulation between states of a deterministic automaton [BK08, Def. 7.47].
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "libplan/model/road_graph.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/roads/road_hierarchy.hpp"

namespace waymark::plan {

enum class LegRole : std::uint8_t { Passed, Leads, Either, Closed };  // of the nodes of a letter, in a state
// May a leg pass nodes of this role?
inline bool passes(LegRole role) { return role == LegRole::Passed || role == LegRole::Either; }
// Does a leg end at them?
inline bool leads(LegRole role) { return role == LegRole::Leads || role == LegRole::Either; }

// Of one task.
class LegRoles {
 public:
  // Letters without a bit in the hierarchy, whose nodes are all in its core, may be passed where they do no harm: they
  // are few, and legs name their nodes. Other letters end legs at the first node, which is as near as any behind it.
  // Nothing is known to do no harm where more than `pairs` of states would have to be looked at.
  LegRoles(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task,
           std::size_t pairs = std::size_t{1} << 16U);

  std::vector<LegRole> of(std::uint32_t state) const;  // by letter
  // L(state) ⊆ L(δ(state, letter)), as far as it is known.
  bool is_harmless(std::uint32_t state, LetterId letter) const {
    return !harmless_.empty() && harmless_[std::size_t{state} * letters_ + letter.index];
  }
  bool is_in_core(LetterId letter) const { return in_core_[letter.index]; }  // every node of the letter

 private:
  const TaskTable& task_;
  std::size_t letters_;
  std::vector<bool> in_core_;   // by letter
  std::vector<bool> harmless_;  // by state and letter; none: not known
};

}  // namespace waymark::plan
