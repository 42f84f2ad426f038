#include "libplan/solve/route_planner.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace waymark::plan {
namespace {

constexpr std::size_t polling_interval = 4096;  // pairs between two looks at the stop token

}  // namespace

RoutePlanner::RoutePlanner(const Map& map, const automata::Dfa& dfa)
    : task_(map, dfa, TaskSteps::Traps::LeftOut), model_(map), words_(map.poses() / 64 + 1), row_(dfa.states(), none) {
  for ([[maybe_unused]] Action action : all_actions) assert(map.cost(action) == map.cost(Action::Forward));
}

void RoutePlanner::forget() {
  for (const Met& pair : met_) row_[pair.state.task] = none;
  met_.clear();
  seen_.clear();
  edges_ = 0;
}

std::uint64_t* RoutePlanner::bits_of(std::uint32_t task) {
  std::uint32_t& row = row_[task];
  if (row == none) {
    row = static_cast<std::uint32_t>(seen_.size() / words_);
    seen_.resize(seen_.size() + words_, 0);
  }
  return seen_.data() + row * words_;
}

bool RoutePlanner::meet(const Met& pair) {
  std::uint64_t& word = bits_of(pair.state.task)[pair.state.place / 64];
  const std::uint64_t bit = std::uint64_t{1} << (pair.state.place % 64);
  if ((word & bit) != 0) return false;
  word |= bit;
  met_.push_back(pair);
  return task_.is_goal(pair.state.task);
}

bool RoutePlanner::expand(std::uint32_t i) {
  const Product product(model_, task_);
  const ProductState from = met_[i].state;
  bool done = false;
  for (std::uint32_t k = 0, choices = product.choices(from); k < choices && !done; ++k, ++edges_)
    product.for_each_successor(from, k, [&](const ProductState& to) { done = meet({to, i, k}); });
  return done;
}

RoutePlanner::Result RoutePlanner::plan(std::span<const PoseId> starts, const std::stop_token& stop) {
  forget();
  const Product product(model_, task_);
  for (PoseId start : starts) {
    bool done = false;
    product.for_each_start(start.index, task_.map().label_id(start), [&](const ProductState& s) {
      done = meet({s, none});
    });
    if (done) return route();
  }
  for (std::uint32_t i = 0; i < met_.size(); ++i) {  // grows while we look
    if (i % polling_interval == 0 && stop.stop_requested()) return Exhausted{i};
    if (expand(i)) return route();
  }
  return Infeasible{no_run(task_.dfa(), met_.size())};
}

Route RoutePlanner::route() const {
  Trajectory trajectory;
  for (std::uint32_t i = static_cast<std::uint32_t>(met_.size()) - 1; i != none; i = met_[i].from) {
    trajectory.poses.push_back(PoseId{met_[i].state.place});
    if (const std::uint32_t from = met_[i].from; from != none)
      trajectory.actions.push_back(model_.move(met_[from].state.place, met_[i].choice));
  }
  std::reverse(trajectory.poses.begin(), trajectory.poses.end());
  std::reverse(trajectory.actions.begin(), trajectory.actions.end());
  return priced(std::move(trajectory), task_.map());
}

}  // namespace waymark::plan
