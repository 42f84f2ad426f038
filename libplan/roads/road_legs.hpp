// The legs that leave one state of a task: from nodes with costs, past nodes that may be passed, to nodes that lead on.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "libplan/model/road_graph.hpp"
#include "libplan/roads/leg_roles.hpp"
#include "libplan/roads/road_hierarchy.hpp"
#include "libplan/solve/dijkstra.hpp"

namespace waymark::plan {

class RoadLegs {
 public:
  struct Hop {               // a part of a leg
    std::uint32_t from, to;  // ranks
    std::uint32_t arc;       // of the hierarchy, or `by_road`: an arc of the map
  };
  static constexpr std::uint32_t by_road = UINT32_MAX;  // no arc of the hierarchy

  RoadLegs(const RoadGraph& graph, const RoadHierarchy& hierarchy, std::stop_token stop);

  // The state that is searched from, by the role of every letter. Forgets what was found before.
  void begin(std::vector<LegRole> role);
  // A node that may be passed and was reached at this cost; `entry` comes back with the legs.
  void add_source(std::uint32_t node, std::uint64_t cost, std::uint32_t entry);
  // Least costs of all nodes that lead on, or of `target` alone. Costs from `limit` on do not matter. false: stopped.
  bool run(std::uint64_t limit, std::uint32_t target = any);
  static constexpr std::uint32_t any = UINT32_MAX;

  // visit(node, cost): nodes that lead on and were reached, in the order in which they were met.
  template <class Visit>
  void for_each_reached(const Visit& visit) const {
    for (const Visited& v : visits_)
      if (v.leads && v.cost != unreached) visit(hierarchy_.node(v.rank), v.cost);
  }
  // From the source to the node; the entry of the source. O(hops).
  std::pair<std::uint32_t, std::vector<Hop>> leg(std::uint32_t node) const;
  const SearchStatistics& statistics() const { return statistics_; }

 private:
  static constexpr std::uint64_t unreached = UINT64_MAX;
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Visited {
    std::uint32_t rank = 0;
    std::uint32_t from = none;  // a visit; none: a source, or not reached
    std::uint32_t via = none;   // the arc from there; of a source its entry
    bool passed = false;        // may be passed
    bool leads = false;         // ends a leg
    bool wanted = false;        // in the core: its cost matters below it
    std::uint64_t cost = unreached;
  };
  LegRole role(std::uint32_t rank) const { return role_[hierarchy_.letter(rank).index]; }
  bool usable(const RoadHierarchy::Arc& arc, std::uint16_t way) const {
    return (arc.ways & way) != 0 && (arc.passed == 0 || (hierarchy_.sets()[arc.passed] & barriers_) == 0);
  }
  std::uint32_t met(std::uint32_t rank) const { return slot_.get()[rank]; }  // visit + 1, or 0
  std::uint32_t meet(std::uint32_t rank, LegRole role);
  void relax(std::uint32_t from, std::uint32_t to, std::uint64_t cost, std::uint32_t via);
  void collect_up();
  void collect_down(std::uint32_t target);
  void sweep_up();
  bool cross_core(std::uint64_t limit, std::uint32_t target);
  void sweep_down();
  bool cross_passed(std::uint64_t limit);
  template <class Chosen>
  std::size_t count(const Chosen& chosen) const;

  const RoadGraph& graph_;
  const RoadHierarchy& hierarchy_;
  std::stop_token stop_;
  std::vector<LegRole> role_;
  std::uint64_t barriers_ = 0;  // bits of letters that may not be passed
  struct Free {
    void operator()(std::uint32_t* p) const { std::free(p); }
  };
  std::unique_ptr<std::uint32_t[], Free> slot_;  // by rank; pages that are never written take no memory
  std::vector<Visited> visits_;
  std::vector<std::uint32_t> up_, down_;  // visits below the core, by rank
  SearchStatistics statistics_;
};

}  // namespace waymark::plan
