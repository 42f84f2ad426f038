#include "libplan/roads/leg_roles.hpp"

#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace waymark::plan {
namespace {

constexpr std::size_t most_steps = std::size_t{1} << 22U;  // of the task on letters, that are compared

// One letter for all on which every state does the same. None where these would be too many comparisons.
std::vector<LetterId> representatives(const TaskTable& task, std::size_t letters) {
  std::vector<LetterId> out;
  if (letters * task.states() > most_steps) return out;
  std::map<std::vector<std::uint32_t>, bool> seen;
  for (std::uint32_t l = 0; l < letters; ++l) {
    std::vector<std::uint32_t> column;
    for (std::uint32_t q = 0; q < task.states(); ++q) column.push_back(task.next(q, LetterId{l}).target);
    if (seen.emplace(std::move(column), true).second) out.push_back(LetterId{l});
  }
  return out;
}

// Which pairs (p, q) have L(p) ⊆ L(q)? Pairs that others depend on are collected, then those that fail are spread
// against the steps.
class Inclusions {
 public:
  Inclusions(const TaskTable& task, std::vector<LetterId> letters, std::size_t most)
      : task_(task), letters_(std::move(letters)), most_(most) {}

  using Verdict = std::optional<bool>;
  // Known at once, or else a number among those that `solve` decides.
  std::pair<Verdict, std::uint32_t> add(std::uint32_t p, std::uint32_t q) {
    constexpr std::uint32_t trap = TaskTable::trap;
    if (p == q || p == trap) return {true, 0};
    if (q == trap) return {false, 0};
    if (task_.is_goal(q)) return {true, 0};
    if (task_.is_goal(p)) return {false, 0};
    const auto [found, fresh] =
        numbers_.try_emplace((std::uint64_t{p} << 32U) | q, static_cast<std::uint32_t>(pairs_.size()));
    if (fresh) {
      pairs_.emplace_back(p, q);
      before_.emplace_back();
    }
    return {std::nullopt, found->second};
  }
  bool solve() {  // false: too many pairs
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
      if (pairs_.size() > most_) return false;
      const auto [p, q] = pairs_[i];
      bool fails = false;
      for (const LetterId l : letters_) {
        const auto [verdict, next] = add(task_.next(p, l).target, task_.next(q, l).target);
        if (!verdict) before_[next].push_back(i);
        fails |= verdict == false;
      }
      fails_.push_back(fails);
      if (fails) open.push_back(i);
    }
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      for (const std::uint32_t b : before_[i])
        if (!fails_[b]) {
          fails_[b] = true;
          open.push_back(b);
        }
    }
    return true;
  }
  bool holds(std::uint32_t pair) const { return !fails_[pair]; }

 private:
  const TaskTable& task_;
  std::vector<LetterId> letters_;
  std::size_t most_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  std::vector<std::vector<std::uint32_t>> before_;
  std::vector<bool> fails_;
};

}  // namespace

LegRoles::LegRoles(const RoadGraph& graph, const RoadHierarchy& hierarchy, const TaskTable& task, std::size_t pairs)
    : task_(task), letters_(graph.letters().size()), in_core_(letters_, true) {
  in_core_[0] = false;
  for (const std::uint32_t l : hierarchy.bits()) in_core_[l] = false;
  Inclusions inclusions(task, representatives(task, letters_), pairs);
  struct Asked {
    std::size_t at;
    Inclusions::Verdict verdict;
    std::uint32_t pair;
  };
  std::vector<Asked> asked;
  for (std::uint32_t q = 0; q < task.states() && letters_ * task.states() <= most_steps; ++q) {
    if (task.is_goal(q)) continue;
    for (std::uint32_t l = 0; l < letters_; ++l) {
      const std::uint32_t next = task.next(q, LetterId{l}).target;
      if (!in_core_[l] || next == q || next == TaskTable::trap) continue;
      const auto [verdict, pair] = inclusions.add(q, next);
      asked.push_back({q * letters_ + l, verdict, pair});
    }
  }
  if (!inclusions.solve()) return;
  harmless_.assign(letters_ * task.states(), false);
  for (const Asked& a : asked) harmless_[a.at] = a.verdict ? *a.verdict : inclusions.holds(a.pair);
}

std::vector<LegRole> LegRoles::of(std::uint32_t state) const {
  std::vector<LegRole> out;
  for (std::uint32_t l = 0; l < letters_; ++l) {
    const std::uint32_t next = task_.next(state, LetterId{l}).target;
    out.push_back(next == state                     ? LegRole::Passed
                  : next == TaskTable::trap         ? LegRole::Closed
                  : is_harmless(state, LetterId{l}) ? LegRole::Either
                                                    : LegRole::Leads);
  }
  return out;
}

}  // namespace waymark::plan
