#include "libplan/roads/shared_legs.hpp"

#include <algorithm>
#include <utility>

namespace waymark::plan {
namespace {

constexpr std::size_t most_roles = std::size_t{1} << 22U;  // of letters in states, that are compared
constexpr std::size_t most_ends = std::size_t{1} << 12U;   // nodes, of a group

}  // namespace

SharedLegs::SharedLegs(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task,
                       const LegRoles& roles, Use use, std::size_t kept_legs)
    : graph_(graph),
      hierarchy_(hierarchy),
      task_(task),
      roles_(roles),
      kept_legs_(kept_legs),
      group_of_(task.states()) {
  const std::size_t letters = graph.letters().size();
  if (use == Use::Never || letters * task.states() > most_roles) return;
  std::vector<Letters> exact;
  Letters somewhere(letters, false);  // of the core, passed in some state
  for (std::uint32_t q = 0; q < task.states(); ++q) {
    exact.emplace_back(letters, false);
    if (task.is_goal(q)) continue;
    const std::vector<LegRole> role = roles.of(q);
    for (std::uint32_t l = 0; l < letters; ++l)
      if (passes(role[l])) {
        exact[q][l] = true;
        if (roles.is_in_core(LetterId{l})) somewhere[l] = true;
      }
  }
  for (std::uint32_t q = 0; q < task.states(); ++q) {
    if (task.is_goal(q)) continue;
    Letters more = exact[q];
    for (std::uint32_t l = 0; l < letters; ++l)
      if (somewhere[l]) more[l] = true;
    group_of_[q].exact = number(exact[q]);
    group_of_[q].number = number(more);
    for (std::uint32_t l = 0; l < letters; ++l)
      if (const std::uint32_t next = task.next(q, LetterId{l}).target; next != q && next != TaskTable::trap)
        ends_[group_of_[q].exact][l] = ends_[group_of_[q].number][l] = true;
  }
  choose(use);
}

std::uint32_t SharedLegs::number(const Letters& passed) {
  const auto [found, fresh] = numbers_.try_emplace(passed, static_cast<std::uint32_t>(passed_.size()));
  if (fresh) {
    passed_.push_back(passed);
    ends_.emplace_back(passed.size(), false);
  }
  return found->second;
}

// Groups that are shared: by how many nodes, and by how many states, they can be entered.
void SharedLegs::choose(Use use) {
  const std::size_t letters = graph_.letters().size();
  std::vector<Letters> entered(passed_.size(), Letters(letters, false));
  std::vector<std::size_t> states(passed_.size(), 0), nodes(passed_.size(), 1),
      ends(passed_.size(), 0);  // 1: the start
  for (std::uint32_t q = 0; q < task_.states(); ++q) {
    if (task_.is_goal(q)) continue;
    ++states[group_of_[q].number];
    for (std::uint32_t l = 0; l < letters; ++l)
      if (const std::uint32_t next = task_.next(q, LetterId{l}).target;
          next != q && next != TaskTable::trap && !task_.is_goal(next))
        entered[group_of_[next].number][l] = true;
  }
  for (std::size_t g = 0; g < passed_.size(); ++g)
    for (std::uint32_t l = 0; l < letters; ++l) {
      if (entered[g][l]) nodes[g] += graph_.count(LetterId{l});
      if (ends_[g][l]) ends[g] += graph_.count(LetterId{l});
    }
  for (std::uint32_t q = 0; q < task_.states(); ++q) {
    if (task_.is_goal(q)) continue;
    const std::uint32_t g = group_of_[q].number;
    group_of_[q].shared = use == Use::Always || (nodes[g] < states[g] && ends[g] <= most_ends);
  }
}

bool SharedLegs::is_end(std::uint32_t state, std::uint32_t node) const {
  const std::uint32_t next = task_.next(state, graph_.letter(node)).target;
  return next != state && next != TaskTable::trap;
}

bool SharedLegs::may_pass(std::uint32_t state, const End& end) const {
  const Letters& passed = passed_[group_of_[state].exact];
  return std::all_of(end.passed.begin(), end.passed.end(), [&](LetterId l) { return passed[l.index]; });
}

const std::vector<SharedLegs::End>* SharedLegs::ends_of(RoadLegs& search, std::uint32_t node,
                                                        std::uint32_t restriction) {
  const std::uint64_t key = (std::uint64_t{restriction} << 32U) | node;
  if (const auto found = kept_.find(key); found != kept_.end()) return &found->second;
  const Letters &passed = passed_[restriction], &ends = ends_[restriction];
  std::vector<LegRole> role;
  for (std::size_t l = 0; l < passed.size(); ++l)
    role.push_back(passed[l] ? (ends[l] ? LegRole::Either : LegRole::Passed)
                             : (ends[l] ? LegRole::Leads : LegRole::Closed));
  search.begin(std::move(role));
  for (const RoadGraph::Arc& arc : graph_.arcs(node))
    if (passed[graph_.letter(arc.to).index]) search.add_source(arc.to, arc.cost, 0);
  if (!search.run(UINT64_MAX)) return nullptr;
  return &kept_.emplace(key, found(search)).first->second;
}

std::vector<SharedLegs::End> SharedLegs::found(const RoadLegs& search) const {
  std::vector<End> out;
  search.for_each_reached([&](std::uint32_t node, std::uint64_t cost) { out.push_back({node, cost, {}, {}}); });
  const bool kept = out.size() <= kept_legs_;
  for (End& end : out) {
    std::vector<RoadLegs::Hop> hops = search.leg(end.node).second;
    for (const RoadLegs::Hop& hop : hops) {
      const LetterId letter = hierarchy_.letter(hop.from);
      if (roles_.is_in_core(letter) && std::find(end.passed.begin(), end.passed.end(), letter) == end.passed.end())
        end.passed.push_back(letter);
    }
    if (kept) end.leg = std::move(hops);
  }
  return out;
}

}  // namespace waymark::plan
