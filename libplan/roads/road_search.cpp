#include "libplan/roads/road_search.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "libplan/roads/leg_roles.hpp"
#include "libplan/roads/road_legs.hpp"

namespace waymark::plan {
namespace {

class RoadSearch {
 public:
  RoadSearch(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task,
             const RoadSearchOptions& options)
      : graph_(graph),
        hierarchy_(hierarchy),
        task_(task),
        options_(options),
        legs_(graph, hierarchy, options.stop),
        roles_(graph, hierarchy, task),
        shared_(graph, hierarchy, task, roles_, options.shared, options.kept_legs),
        at_(task.states()) {}

  std::optional<RoadAnswer> run() {
    RoadAnswer answer;
    if (task_.initial_states().empty()) return answer;
    const std::uint32_t first = task_.next(task_.initial_states()[0], graph_.letter(graph_.start())).target;
    if (first == TaskTable::trap) return answer;
    enter(graph_.start(), first, 0, none);
    const auto& components = task_.components();
    for (std::size_t c = components.size() - 1; c-- > 0;)
      if (!search_component(components[c], components[c + 1])) return std::nullopt;
    if (goal_ != none) {
      answer.route = route();
      if (!answer.route) return std::nullopt;
    }
    answer.statistics = legs_.statistics();
    return answer;
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  static constexpr std::size_t nodes_looked_at = 64;  // of a letter
  struct Entry {                                      // a node where a state of the task is entered
    std::uint32_t node = 0, state = 0;
    std::uint64_t cost = UINT64_MAX;
    std::uint32_t before = none;     // the entry it is reached from
    bool pending = false;            // nothing was searched for from here, at this cost
    bool has_leg = false;            // else it is searched for again
    std::uint32_t passed = none;     // the first node of the leg when it does not lead on at once
    std::vector<RoadLegs::Hop> leg;  // from there
  };

  std::uint64_t limit() const { return goal_ == none ? UINT64_MAX : entries_[goal_].cost; }

  // The entry, where it became cheaper.
  Entry* enter(std::uint32_t node, std::uint32_t state, std::uint64_t cost, std::uint32_t before) {
    const auto [found, fresh] = at_[state].try_emplace(node, static_cast<std::uint32_t>(entries_.size()));
    if (fresh) {
      entries_.emplace_back();
      entries_.back().node = node;
      entries_.back().state = state;
    }
    Entry& entry = entries_[found->second];
    if (cost >= entry.cost) return nullptr;
    entry.cost = cost;
    entry.before = before;
    entry.has_leg = false;
    entry.passed = none;
    entry.leg.clear();
    if (task_.is_goal(state)) {
      if (cost < limit()) goal_ = found->second;
    } else if (!entry.pending) {
      entry.pending = true;
      pending_.push_back(found->second);
    }
    return &entry;
  }

  // States first … last − 1, until nothing in them becomes cheaper.
  bool search_component(std::uint32_t first, std::uint32_t last) {
    for (;;) {
      std::uint32_t state = none;
      std::uint64_t least = UINT64_MAX;
      for (const std::uint32_t e : pending_)
        if (entries_[e].state >= first && entries_[e].state < last && entries_[e].cost < least) {
          least = entries_[e].cost;
          state = entries_[e].state;
        }
      if (state == none) return true;
      std::vector<std::uint32_t> from, rest;
      for (const std::uint32_t e : pending_) (entries_[e].state == state ? from : rest).push_back(e);
      pending_ = std::move(rest);
      for (const std::uint32_t e : from) entries_[e].pending = false;
      if (!search_from(state, from)) return false;
    }
  }

  // Could an entry of the state, at this cost or more, make another entry cheaper? Not where all nodes that lead on
  // from it were entered at no more than that: as after a landmark, when a task falls back to before it.
  bool matters(std::uint32_t state, std::uint64_t cost) const {
    if (task_.is_goal(state)) return cost < limit();
    for (std::uint32_t l = 0; l < graph_.letters().size(); ++l) {
      const std::uint32_t next = task_.next(state, LetterId{l}).target;
      if (next == state || next == TaskTable::trap) continue;
      if (l == 0 || graph_.count(LetterId{l}) > nodes_looked_at) return true;
      for (const std::uint32_t node : graph_.nodes_of(LetterId{l})) {
        const auto found = at_[next].find(node);
        if (found == at_[next].end() || entries_[found->second].cost > cost) return true;
      }
    }
    return false;
  }
  // Letters whose entries would not matter are no ends.
  std::vector<LegRole> roles_that_matter(std::uint32_t state, std::uint64_t cost) const {
    std::vector<LegRole> out = roles_.of(state);
    for (std::uint32_t l = 0; l < out.size(); ++l)
      if (leads(out[l]) && !matters(task_.next(state, LetterId{l}).target, cost))
        out[l] = passes(out[l]) ? LegRole::Passed : LegRole::Closed;
    return out;
  }

  bool may_pass(std::uint32_t state, LetterId letter) const {
    return task_.next(state, letter).target == state || roles_.is_harmless(state, letter);
  }

  // The first arc of every leg is one of the map; it may lead on at once. visit(node, cost) where it may be passed.
  template <class Visit>
  void take_first_arcs(std::uint32_t e, const Visit& visit) {
    const std::uint32_t node = entries_[e].node, state = entries_[e].state;
    const std::uint64_t cost = entries_[e].cost;
    for (const RoadGraph::Arc& arc : graph_.arcs(node)) {
      const LetterId letter = graph_.letter(arc.to);
      const std::uint32_t next = task_.next(state, letter).target;
      if (may_pass(state, letter)) visit(arc.to, cost + arc.cost);
      if (next == state || next == TaskTable::trap) continue;
      if (Entry* entry = enter(arc.to, next, cost + arc.cost, e)) entry->has_leg = true;
    }
  }

  bool search_from(std::uint32_t state, const std::vector<std::uint32_t>& from) {
    if (shared_.is_shared(state)) {
      for (const std::uint32_t e : from)
        if (!take_shared_legs(e)) return false;
      return true;
    }
    std::uint64_t least = UINT64_MAX;
    for (const std::uint32_t e : from) least = std::min(least, entries_[e].cost);
    legs_.begin(roles_that_matter(state, least));
    for (const std::uint32_t e : from)
      if (entries_[e].cost < limit())
        take_first_arcs(e, [&](std::uint32_t node, std::uint64_t cost) { legs_.add_source(node, cost, e); });
    if (!legs_.run(limit())) return false;
    std::vector<std::pair<std::uint32_t, std::uint64_t>> reached;
    legs_.for_each_reached([&](std::uint32_t node, std::uint64_t cost) { reached.emplace_back(node, cost); });
    for (const auto& [node, cost] : reached) {
      Entry* entry = enter(node, task_.next(state, graph_.letter(node)).target, cost, none);
      if (entry == nullptr) continue;
      auto [before, hops] = legs_.leg(node);
      entry->before = before;
      if (reached.size() > options_.kept_legs) continue;
      keep(*entry, std::move(hops));
    }
    return true;
  }

  bool take_shared_legs(std::uint32_t e) {
    const std::uint32_t node = entries_[e].node, state = entries_[e].state;
    const std::uint64_t cost = entries_[e].cost;
    if (cost >= limit()) return true;
    take_first_arcs(e, [](std::uint32_t, std::uint64_t) {});
    return shared_.for_each_end(legs_, node, state, [&](const SharedLegs::End& end) {
      enter(end.node, task_.next(state, graph_.letter(end.node)).target, cost + end.cost, e);
    });
  }

  void keep(Entry& entry, std::vector<RoadLegs::Hop> hops) const {
    entry.has_leg = true;
    entry.passed = hierarchy_.node(hops.front().from);
    entry.leg = std::move(hops);
  }

  // A leg that is kept among shared ones, or not at all.
  bool search_again(Entry& entry) {
    const Entry& before = entries_[entry.before];
    if (shared_.is_shared(before.state)) {
      const auto take = [&](const SharedLegs::End& end) {
        if (end.node == entry.node && before.cost + end.cost == entry.cost && !end.leg.empty()) keep(entry, end.leg);
      };
      if (!shared_.for_each_end(legs_, before.node, before.state, take)) return false;
      if (entry.has_leg) return true;
    }
    legs_.begin(roles_.of(before.state));
    for (const RoadGraph::Arc& arc : graph_.arcs(before.node))
      if (may_pass(before.state, graph_.letter(arc.to))) legs_.add_source(arc.to, before.cost + arc.cost, entry.before);
    if (!legs_.run(UINT64_MAX, entry.node)) return false;
    keep(entry, legs_.leg(entry.node).second);
    return true;
  }

  std::optional<RoadRoute> route() {
    std::vector<std::uint32_t> ends;
    for (std::uint32_t e = goal_; e != none; e = entries_[e].before) ends.push_back(e);
    std::reverse(ends.begin(), ends.end());
    RoadRoute out{{graph_.start()}, 0};
    for (std::size_t i = 1; i < ends.size(); ++i) {
      Entry& entry = entries_[ends[i]];
      if (!entry.has_leg && !search_again(entry)) return std::nullopt;
      if (entry.passed == none) {
        out.nodes.push_back(entry.node);
        continue;
      }
      out.nodes.push_back(entry.passed);
      for (const RoadLegs::Hop& hop : entry.leg) {
        if (hop.arc == RoadLegs::by_road)
          out.nodes.push_back(hierarchy_.node(hop.to));
        else
          hierarchy_.unpack(hop.from, hop.to, hierarchy_.arc(hop.arc), out.nodes);
      }
    }
    out.cost = cost_of(out.nodes);
    if (out.cost != entries_[goal_].cost)
      throw std::logic_error("a route on roads whose steps cost other than claimed");
    end_at_goal(out);
    return out;
  }

  // What a leg has passed may have led to a goal before; all from there on costs nothing.
  void end_at_goal(RoadRoute& route) const {
    std::uint32_t state = entries_.front().state;
    std::size_t taken = 1;
    while (taken < route.nodes.size() && state != TaskTable::trap && !task_.is_goal(state))
      state = task_.next(state, graph_.letter(route.nodes[taken++])).target;
    if (state == TaskTable::trap || !task_.is_goal(state)) throw std::logic_error("a route on roads to no goal");
    route.nodes.resize(taken);
    if (cost_of(route.nodes) != route.cost) throw std::logic_error("a route on roads past a cheaper one");
  }

  std::uint64_t cost_of(const std::vector<std::uint32_t>& nodes) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      std::uint64_t least = UINT64_MAX;
      for (const RoadGraph::Arc& arc : graph_.arcs(nodes[i - 1]))
        if (arc.to == nodes[i]) least = std::min<std::uint64_t>(least, arc.cost);
      if (least == UINT64_MAX) throw std::logic_error("a route that takes a road that is not there");
      sum += least;
    }
    return sum;
  }

  const RoadGraph& graph_;
  const RoadHierarchy& hierarchy_;
  const TaskTable& task_;
  const RoadSearchOptions& options_;
  RoadLegs legs_;
  LegRoles roles_;
  SharedLegs shared_;
  std::vector<std::unordered_map<std::uint32_t, std::uint32_t>> at_;  // by state, by node: the entry
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> pending_;
  std::uint32_t goal_ = none;
};

}  // namespace

std::optional<RoadAnswer> least_route(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task,
                                      const RoadSearchOptions& options) {
  return RoadSearch(graph, hierarchy, task, options).run();
}

}  // namespace waymark::plan
