// Legs that several states of a task have in common: searched once for each node and restriction.
//
// What a leg may pass is all that a state says about it, besides where it ends. States that may pass the same letters
// form a group; a search from one node finds its legs to all nodes where a leg of the group ends. Letters of the core
// that some state may pass are passed at first by all groups that differ in them alone, and every end remembers those
// on its way. A state that may not pass one of them asks for a search of its own, which is kept as well. So 64 states
// of a task in any order have seven searches, not 64, where each landmark is one node.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "libplan/model/road_graph.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/roads/leg_roles.hpp"
#include "libplan/roads/road_hierarchy.hpp"
#include "libplan/roads/road_legs.hpp"

namespace waymark::plan {

class SharedLegs {
 public:
  enum class Use : std::uint8_t { WhereFewer, Always, Never };  // of these legs, or of a search for each state
  struct End {                                                  // of a leg
    std::uint32_t node = 0;                                     // where it ends
    std::uint64_t cost = 0;                                     // from the node the search began at
    std::vector<LetterId> passed;                               // of the core, on the way
    std::vector<RoadLegs::Hop> leg;                             // none: not kept
  };

  // Where fewer: groups whose states can be entered at fewer nodes than they are states, and end at few nodes. Legs of
  // at most so many ends of a search are kept.
  SharedLegs(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task, const LegRoles& roles,
             Use use, std::size_t kept_legs);

  // Does another state use the legs of this one?
  bool is_shared(std::uint32_t state) const { return group_of_[state].shared; }
  // visit(end): those of the state, from the node, past one node or more. false: stopped.
  template <class Visit>
  bool for_each_end(RoadLegs& search, std::uint32_t node, std::uint32_t state, const Visit& visit) {
    const Group& group = group_of_[state];
    const std::vector<End>* ends = ends_of(search, node, group.number);
    bool all = true;
    if (ends == nullptr) return false;
    for (const End& end : *ends) {
      if (!is_end(state, end.node)) continue;
      if (may_pass(state, end))
        visit(end);
      else
        all = false;
    }
    if (all) return true;
    ends = ends_of(search, node, group.exact);
    if (ends == nullptr) return false;
    for (const End& end : *ends)
      if (is_end(state, end.node)) visit(end);
    return true;
  }

 private:
  struct Group {               // of a state
    std::uint32_t number = 0;  // in passed_: what it may pass, and letters of the core
    std::uint32_t exact = 0;   // in passed_: what it may pass
    bool shared = false;
  };
  using Letters = std::vector<bool>;  // by letter
  std::uint32_t number(const Letters& passed);
  bool is_end(std::uint32_t state, std::uint32_t node) const;
  bool may_pass(std::uint32_t state, const End& end) const;
  const std::vector<End>* ends_of(RoadLegs& search, std::uint32_t node, std::uint32_t restriction);
  std::vector<End> found(const RoadLegs& search) const;
  void choose(Use use);

  const RoadGraph& graph_;
  const RoadHierarchy& hierarchy_;
  const TaskTable& task_;
  const LegRoles& roles_;
  std::size_t kept_legs_;
  std::vector<Group> group_of_;                               // by state
  std::vector<Letters> passed_;                               // by number of a restriction
  std::vector<Letters> ends_;                                 // by the same: where legs of its states end
  std::map<Letters, std::uint32_t> numbers_;                  // of restrictions
  std::unordered_map<std::uint64_t, std::vector<End>> kept_;  // by restriction and node
};

}  // namespace waymark::plan
