#include "libplan/solve/route_planner.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace waymark::plan {
namespace {

constexpr std::size_t polling_interval = 4096;  // pairs between two looks at the stop token

}  // namespace

RoutePlanner::RoutePlanner(const Map& map, const automata::Dfa& dfa)
    : steps_(map, dfa), words_(map.poses() / 64 + 1), row_(dfa.states(), none) {
  for ([[maybe_unused]] Action action : all_actions) assert(map.cost(action) == map.cost(Action::Forward));
}

void RoutePlanner::forget() {
  for (const Met& pair : met_) row_[pair.task.index] = none;
  met_.clear();
  seen_.clear();
  edges_ = 0;
}

std::uint64_t* RoutePlanner::bits_of(automata::StateId task) {
  std::uint32_t& row = row_[task.index];
  if (row == none) {
    row = static_cast<std::uint32_t>(seen_.size() / words_);
    seen_.resize(seen_.size() + words_, 0);
  }
  return seen_.data() + row * words_;
}

bool RoutePlanner::meet(const Met& pair) {
  std::uint64_t& word = bits_of(pair.task)[pair.pose.index / 64];
  const std::uint64_t bit = std::uint64_t{1} << (pair.pose.index % 64);
  if ((word & bit) != 0) return false;
  word |= bit;
  met_.push_back(pair);
  return steps_.dfa().is_accepting(pair.task);
}

bool RoutePlanner::expand(std::uint32_t i) {
  const Met from = met_[i];
  const Map& map = steps_.map();
  for (Action action : all_actions) {
    const auto pose = map.successor(from.pose, action);
    if (!pose) continue;
    ++edges_;
    const automata::StateId task = steps_.next(from.task, map.letter_id(*pose, action));
    if (!steps_.dfa().is_trap(task) && meet({*pose, task, i, action})) return true;
  }
  return false;
}

RoutePlanner::Answer RoutePlanner::plan(std::span<const PoseId> starts, const std::stop_token& stop) {
  forget();
  for (PoseId start : starts) {
    const automata::StateId task = steps_.next(steps_.dfa().initial(), steps_.map().label_id(start));
    if (!steps_.dfa().is_trap(task) && meet({start, task, none})) return route();
  }
  for (std::uint32_t i = 0; i < met_.size(); ++i) {  // grows while we look
    if (i % polling_interval == 0 && stop.stop_requested()) return Exhausted{i};
    if (expand(i)) return route();
  }
  return Infeasible{no_run(steps_.dfa(), met_.size())};
}

Route RoutePlanner::route() const {
  Trajectory trajectory;
  for (std::uint32_t i = static_cast<std::uint32_t>(met_.size()) - 1; i != none; i = met_[i].from) {
    trajectory.poses.push_back(met_[i].pose);
    if (met_[i].from != none) trajectory.actions.push_back(met_[i].by);
  }
  std::reverse(trajectory.poses.begin(), trajectory.poses.end());
  std::reverse(trajectory.actions.begin(), trajectory.actions.end());
  return priced(std::move(trajectory), steps_.map());
}

}  // namespace waymark::plan
