#include "libplan/least_by_progression.hpp"

#include <set>
#include <utility>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::plan {

std::optional<LeastActions> least_by_progression(ltl::Formula formula, const Map& map, std::span<const PoseId> starts,
                                                 const ltl::Limits& limits) {
  struct Pair {
    PoseId pose;
    ltl::Formula remains;
  };
  std::set<std::pair<std::uint32_t, ltl::Formula>> met;
  std::vector<Pair> layer, next;
  const auto meet = [&](PoseId pose, ltl::Formula remains) {
    if (met.emplace(pose.index, remains).second) next.push_back({pose, remains});
  };
  for (const PoseId start : starts)
    meet(start, ltl::progress(formula, word_for(formula, Trajectory{{start}, {}}, map)[0]));
  for (std::size_t actions = 0; !next.empty(); ++actions) {
    layer.swap(next);
    next.clear();
    for (const Pair& node : layer)
      if (ltl::accepts_empty(node.remains)) return LeastActions{actions, met.size()};
    for (const Pair& node : layer) {
      if (met.size() > limits.states || limits.stop.stop_requested()) return std::nullopt;
      for (const Action action : all_actions)
        if (const auto to = map.successor(node.pose, action)) {
          const ltl::Trace step = word_for(formula, Trajectory{{node.pose, *to}, {action}}, map);
          meet(*to, ltl::progress(node.remains, step[1]));
        }
    }
  }
  return LeastActions{std::nullopt, met.size()};
}

}  // namespace waymark::plan
