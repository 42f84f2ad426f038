#include "libautomata/omega/degeneralize.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "libautomata/graph/numbered_pairs.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

class Levels {
 public:
  Levels(const TransitionRelation& automaton, const LevelRule& rule, Budget& budget)
      : from_(automaton),
        rule_(rule),
        budget_(budget),
        graph_(automaton),
        live_(live_components(graph_, automaton.acceptance.condition)),
        sets_(automaton.acceptance.sets),
        order_(sets_),
        counted_(live_.components.count, false),
        common_(automaton.states(), Marks::first(sets_)) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (rule.descending) std::reverse(order_.begin(), order_.end());
    for (std::uint32_t q = 0; q < graph_.size(); ++q)
      for (const Branch& b : graph_.branches(q))
        if (inside(q, b.target)) {
          common_[q] = common_[q] & b.marks;
          if (b.marks != Marks::first(sets_)) counted_[component(q)] = true;
        }
  }

  using ByState = std::unordered_map<std::uint32_t, std::uint32_t>;
  const ByState& reached() const { return reached_; }  // the highest levels that a component's own branches lead to
  void enter_at(const ByState& levels) { entries_ = levels; }

  TransitionRelation run() {
    TransitionRelation out;
    out.acceptance = Acceptance::buchi();
    out.initial = entry(from_.initial);
    RootCopier copier(from_, out);
    for (std::size_t i = 0; i < copies_.size(); ++i) {  // the copies double as the queue
      const std::uint32_t q = copies_[i].first, level = copies_[i].second;
      const Marks marks = level == sets_ && live_.accepting[component(q)] ? Marks::of(0) : Marks();
      const auto leaf = [&](std::uint32_t c) {
        std::vector<Branch> branches;
        for (const Branch& b : from_.choices[c]) branches.push_back({copy(b.target, after(q, level, b)), marks});
        return out.choices.intern(std::move(branches));
      };
      out.roots.push_back(copier.copy(from_.roots[q], leaf));
    }
    return out;
  }

 private:
  std::uint32_t component(std::uint32_t q) const { return live_.components.of[q]; }
  bool inside(std::uint32_t q, std::uint32_t r) const { return component(q) == component(r); }

  std::uint32_t advance(std::uint32_t level, Marks marks) const {
    while (level < sets_ && marks.contains(order_[level])) ++level;
    return level;
  }
  // The level of the copy that a branch leads to.
  std::uint32_t after(std::uint32_t q, std::uint32_t level, const Branch& b) {
    if (!inside(q, b.target)) return entry_level(b.target);
    const std::uint32_t inner = inner_level(q, level, b);
    std::uint32_t& highest = reached_.try_emplace(b.target, inner).first->second;
    highest = std::max(highest, inner);
    return inner;
  }
  std::uint32_t inner_level(std::uint32_t q, std::uint32_t level, const Branch& b) const {
    if (!live_.accepting[component(q)]) return 0;
    if (!counted_[component(q)]) return sets_;
    Marks marks = b.marks;
    if (level == sets_) {
      level = 0;
      if (rule_.look_ahead && !rule_.count_twice) marks = marks.without(common_[q]);
    }
    level = advance(level, marks);
    return rule_.look_ahead ? advance(level, common_[b.target]) : level;
  }
  std::uint32_t entry_level(std::uint32_t q) {
    if (!live_.accepting[component(q)]) return 0;
    if (!counted_[component(q)]) return sets_;
    if (const auto known = entries_.find(q); known != entries_.end()) return known->second;
    return rule_.look_ahead ? advance(0, common_[q]) : 0;
  }
  std::uint32_t entry(std::uint32_t q) { return copy(q, entry_level(q)); }
  std::uint32_t copy(std::uint32_t q, std::uint32_t level) { return copies_.number(q, level, budget_); }

  const TransitionRelation& from_;
  LevelRule rule_;
  Budget& budget_;
  BranchGraph graph_;
  LiveComponents live_;
  std::uint32_t sets_;
  std::vector<std::uint32_t> order_;
  std::vector<bool> counted_;  // by component: not every branch inside has all marks
  std::vector<Marks> common_;  // of the branches of a state that stay inside its component
  ByState reached_, entries_;
  NumberedPairs copies_;  // (state, level)
};

}  // namespace

TransitionRelation degeneralize(const TransitionRelation& automaton, const LevelRule& rule, Budget& budget) {
  Levels first(automaton, rule, budget);
  first.run();
  Levels second(automaton, rule, budget);  // into copies that are there anyway
  second.enter_at(first.reached());
  return second.run();
}

TransitionRelation with_one_set(TransitionRelation automaton) {
  if (automaton.acceptance.sets > 0) return automaton;
  std::vector<std::uint32_t> all;
  for (std::uint32_t q = 0; q < automaton.states(); ++q) all.push_back(q);
  TransitionRelation out = rebuild(automaton, all, [](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.marks = Marks::of(0);
    return branches;
  });
  out.acceptance = Acceptance::buchi();
  return out;
}

}  // namespace waymark::automata
