#include "libplan/solve/lower_bound.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace waymark::plan {

using automata::StateId;

LowerBound::LowerBound(const TaskSteps& steps)
    : steps_(&steps), cheapest_action_(steps.map().cost(Action::Forward)), bounds_(steps.dfa().states()) {
  for (Action action : all_actions) cheapest_action_ = std::min(cheapest_action_, steps.map().cost(action));
}

double LowerBound::operator()(const ProductState& state) {
  const automata::Dfa& dfa = steps_->dfa();
  const StateId task{state.task};
  if (dfa.is_accepting(task)) return 0;
  if (dfa.is_trap(task)) return std::numeric_limits<double>::infinity();
  std::vector<double>& bounds = bounds_[state.task];
  if (bounds.empty()) bounds = by_pose(task);
  return bounds[state.place];
}

std::vector<double> LowerBound::by_pose(StateId q) {
  const Map& map = steps_->map();
  const automata::Dfa& dfa = steps_->dfa();
  std::vector<double> bounds(map.poses(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto lower = [&](PoseId p, double bound) {
    if (bound >= bounds[p.index]) return;
    bounds[p.index] = bound;
    queue.emplace(bound, p.index);
  };
  for (std::uint32_t i = 0; i < map.poses(); ++i) {  // the moves u –a→ v that leave q
    for (Action action : all_actions) {
      const auto v = map.successor(PoseId{i}, action);
      if (!v) continue;
      const StateId after = steps_->next(q, map.letter_id(*v, action));
      if (after == q || dfa.is_trap(after)) continue;
      lower(PoseId{i}, map.cost(action) + cheapest_action_ * dfa.distance_to_acceptance(after));
    }
  }
  while (!queue.empty()) {
    const auto [bound, pose] = queue.top();
    queue.pop();
    if (bound > bounds[pose]) continue;
    for (Action action : all_actions)
      if (const auto u = map.predecessor(PoseId{pose}, action)) lower(*u, bound + map.cost(action));
  }
  return bounds;
}

}  // namespace waymark::plan
