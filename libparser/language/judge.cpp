#include "libparser/language/judge.hpp"

#include <algorithm>

namespace waymark::parser {
namespace {

using plan::Action;
using Actions = std::vector<Action>;

constexpr std::size_t most_rivals = 120;

const std::vector<Actions>& detours() {  // each ends in the pose where it starts
  static const std::vector<Actions> all = [] {
    constexpr Action f = Action::Forward, l = Action::Left, r = Action::Right;
    std::vector<Actions> out{{l, r}, {r, l}, {l, l, l, l}};
    for (const std::size_t steps : {1U, 2U}) {
      const Actions forward(steps, f);
      const auto aside = [&](const Actions& turn, const Actions& back) {
        Actions one = turn;
        one.insert(one.end(), forward.begin(), forward.end());
        one.insert(one.end(), {l, l});
        one.insert(one.end(), forward.begin(), forward.end());
        one.insert(one.end(), back.begin(), back.end());
        out.push_back(std::move(one));
      };
      aside({}, {l, l});
      aside({l}, {l});
      aside({r}, {r});
      aside({l, l}, {});
    }
    return out;
  }();
  return all;
}

// Shortest ways from one pose to all others.
class Ways {
 public:
  Ways(const plan::Map& map, plan::PoseId from) : from_(from), before_(map.poses()) {
    std::vector<bool> seen(map.poses());
    seen[from.index] = true;
    order_.push_back(from);
    for (std::size_t head = 0; head < order_.size(); ++head)
      for (const Action action : plan::all_actions) {
        const auto next = map.successor(order_[head], action);
        if (!next || seen[next->index]) continue;
        seen[next->index] = true;
        before_[next->index] = {order_[head], action};
        order_.push_back(*next);
      }
  }

  const std::vector<plan::PoseId>& nearest_first() const { return order_; }

  Actions to(plan::PoseId pose) const {
    Actions out;
    for (; pose != from_; pose = before_[pose.index].first) out.push_back(before_[pose.index].second);
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  plan::PoseId from_;
  std::vector<std::pair<plan::PoseId, Action>> before_;
  std::vector<plan::PoseId> order_;
};

// What somebody may walk who was told to go the gold route.
class Walks {
 public:
  Walks(const plan::Map& map, const GoldRoute& gold) : map_(map), gold_(gold) {
    add_edits();
    add_detours();
    add_ways();
  }

  std::vector<plan::Trajectory> take() { return std::move(walks_); }

 private:
  // The first actions of the gold route, others, and the gold route from action `on`.
  void add(std::size_t first, const Actions& others, std::size_t on) {
    Actions actions(gold_.actions.begin(), gold_.actions.begin() + static_cast<std::ptrdiff_t>(first));
    actions.insert(actions.end(), others.begin(), others.end());
    actions.insert(actions.end(), gold_.actions.begin() + static_cast<std::ptrdiff_t>(on), gold_.actions.end());
    if (auto walk = plan::follow(map_, gold_.start, actions)) walks_.push_back(std::move(*walk));
  }

  void add_edits() {
    const std::size_t n = gold_.actions.size();
    for (std::size_t i = n; i-- > 0;) {
      add(i, {}, n);
      add(i, {}, i + 1);
      for (const Action action : plan::all_actions) {
        if (action != gold_.actions[i]) add(i, {action}, i + 1);
        add(i, {action}, i);
      }
    }
  }

  void add_detours() {
    for (std::size_t i = 0; i <= gold_.actions.size(); ++i)
      for (const Actions& detour : detours()) add(i, detour, i);
  }

  // To each place and to the end by way of it.
  void add_ways() {
    const Ways ways(map_, gold_.start);
    std::vector<bool> been(map_.nodes().size());
    for (const plan::PoseId pose : ways.nearest_first()) {
      if (been[map_.node_of(pose)]) continue;
      been[map_.node_of(pose)] = true;
      Actions actions = ways.to(pose);
      walks_.push_back(*plan::follow(map_, gold_.start, actions));
      const Actions on = Ways(map_, pose).to(gold_.end);
      actions.insert(actions.end(), on.begin(), on.end());
      walks_.push_back(*plan::follow(map_, gold_.start, actions));
    }
  }

  const plan::Map& map_;
  const GoldRoute& gold_;
  std::vector<plan::Trajectory> walks_;
};

// Each time the walk that refutes most of the programs left, of these the shortest.
// refutes(walk, program); refuted programs are taken from `rivals`.
template <class Refutes>
std::vector<plan::Trajectory> choose(const std::vector<plan::Trajectory>& walks, std::size_t most,
                                     std::vector<Program>& rivals, const Refutes& refutes) {
  std::vector<plan::Trajectory> chosen;
  while (chosen.size() < most) {
    const plan::Trajectory* best = nullptr;
    std::size_t best_count = 0;
    for (const plan::Trajectory& walk : walks) {
      const auto refuted = [&](const Program& rival) { return refutes(walk, rival); };
      const auto count = static_cast<std::size_t>(std::count_if(rivals.begin(), rivals.end(), refuted));
      const bool is_new = std::find(chosen.begin(), chosen.end(), walk) == chosen.end();
      if (is_new &&
          (!best || count > best_count || (count == best_count && walk.actions.size() < best->actions.size()))) {
        best = &walk;
        best_count = count;
      }
    }
    if (!best) break;
    chosen.push_back(*best);
    std::erase_if(rivals, [&](const Program& rival) { return refutes(*best, rival); });
  }
  return chosen;
}

}  // namespace

Judged judged_trajectories(const Executor& executor, const ProgramLanguage& language, const GoldRoute& gold,
                           const Program& meant, const std::vector<std::string>& tokens, const JudgedLimits& limits) {
  const plan::Map& map = executor.map();
  std::vector<plan::Trajectory> good{*plan::follow(map, gold.start, gold.actions)}, bad;
  std::vector<Program> rivals;
  for (Consistent& one : judged_programs(executor, language, gold, tokens, {good, {}}, most_rivals))
    rivals.push_back(std::move(one.program));
  for (plan::Trajectory& walk : Walks(map, gold).take())
    (executor.satisfies(walk, meant) ? good : bad).push_back(std::move(walk));
  if (limits.also_good > 0)
    for (std::uint32_t p = 0; p < map.poses(); ++p) {
      const auto plan = executor.run(meant, {p});
      if (plan && !plan->actions.empty()) good.push_back(*plan::follow(map, {p}, plan->actions));
    }
  Judged out;
  out.refused = choose(bad, limits.refused, rivals, [&](const plan::Trajectory& walk, const Program& rival) {
    return executor.satisfies(walk, rival);
  });
  out.good = choose(good, limits.also_good, rivals, [&](const plan::Trajectory& walk, const Program& rival) {
    return !executor.satisfies(walk, rival);
  });
  return out;
}

}  // namespace waymark::parser
