#include "libplan/least_by_progression.hpp"

#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t largest_remainder = 2'000;  // subformulas; one that grows further grows without end

struct GrowsWithoutEnd {};  // thrown

// What remains after a letter, simplified: without that, one place suffices to meet ever longer formulas.
class Remains {
 public:
  ltl::Formula after(ltl::Formula f, const ltl::Letter& letter) {
    const ltl::Formula rest = ltl::progress(f, letter);
    if (const auto known = simple_.find(rest); known != simple_.end()) return known->second;
    if (ltl::subformulas(rest).size() > largest_remainder) throw GrowsWithoutEnd{};
    return simple_.emplace(rest, ltl::simplify(rest, ltl::Over::Rest)).first->second;
  }

 private:
  std::unordered_map<ltl::Formula, ltl::Formula> simple_;
};

std::optional<LeastActions> search_by_progression(ltl::Formula formula, const Map& map, std::span<const PoseId> starts,
                                                  const ltl::Limits& limits) {
  struct Pair {
    PoseId pose;
    ltl::Formula remains;
  };
  Remains remains;
  std::set<std::pair<std::uint32_t, ltl::Formula>> met;
  std::vector<Pair> layer, next;
  const auto meet = [&](PoseId pose, ltl::Formula rest) {
    if (met.emplace(pose.index, rest).second) next.push_back({pose, rest});
  };
  for (const PoseId start : starts)
    meet(start, remains.after(formula, word_for(formula, Trajectory{{start}, {}}, map)[0]));
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
          meet(*to, remains.after(node.remains, step[1]));
        }
    }
  }
  return LeastActions{std::nullopt, met.size()};
}

}  // namespace

std::optional<LeastActions> least_by_progression(ltl::Formula formula, const Map& map, std::span<const PoseId> starts,
                                                 const ltl::Limits& limits) {
  try {
    return search_by_progression(formula, map, starts, limits);
  } catch (const GrowsWithoutEnd&) {
    return std::nullopt;
  }
}

}  // namespace waymark::plan
