#include "libautomata/omega/state_merging.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libltl/rewriting/pair_memo.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

constexpr std::size_t most_vertices = 1U << 15U;
constexpr std::size_t most_after_merging = 1U << 12U;  // … of a second product, when states were merged

// The pairs of choices that some letter offers together, for pairs of roots of two automata.
class JointChoicesBelow {
 public:
  JointChoicesBelow(const Mtbdd& first, const Mtbdd& second, Budget& budget)
      : first_(first), second_(second), budget_(budget) {}

  template <class Visit>
  void visit(Node f, Node g, const Visit& visit_pair) {
    seen_.clear();
    walk(f, g, visit_pair);
  }

 private:
  template <class Visit>
  void walk(Node f, Node g, const Visit& visit_pair) {
    const Node none = Mtbdd::terminal(Choices::none);
    if (f == none || g == none) return;
    if (!seen_.insert(f.id, g.id)) return;
    budget_.step();
    const Mtbdd::Variable of_f = first_.variable(f), of_g = second_.variable(g), top = std::min(of_f, of_g);
    if (top == Mtbdd::no_variable) return visit_pair(Mtbdd::payload(f), Mtbdd::payload(g));
    walk(of_f == top ? first_.low(f) : f, of_g == top ? second_.low(g) : g, visit_pair);
    walk(of_f == top ? first_.high(f) : f, of_g == top ? second_.high(g) : g, visit_pair);
  }

  const Mtbdd &first_, &second_;
  Budget& budget_;
  ltl::PairMemo<bool> seen_;
};

// All pairs of states, reachable or not: (q, p) is vertex q · |P| + p. The marks of p follow those of q.
BranchGraph all_pairs(const TransitionRelation& a, const TransitionRelation& b, Budget& budget) {
  BranchGraph out;
  JointChoicesBelow joint(a.diagram, b.diagram, budget);
  const auto width = static_cast<std::uint32_t>(b.states());
  std::vector<Branch> branches;
  for (std::uint32_t q = 0; q < a.states(); ++q)
    for (std::uint32_t p = 0; p < width; ++p) {
      branches.clear();
      joint.visit(a.roots[q], b.roots[p], [&](std::uint32_t mine, std::uint32_t theirs) {
        for (const Branch& x : a.choices[mine])
          for (const Branch& y : b.choices[theirs])
            branches.push_back(
                {x.target * width + y.target, x.marks | Marks::from_bits(y.marks.bits() << a.acceptance.sets)});
      });
      std::sort(branches.begin(), branches.end());
      branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
      out.add_state();
      for (const Branch& branch : branches) out.add(q * width + p, branch);
    }
  return out;
}

// Is some word accepted, where states of the first automaton are one? Depth first, components as they are met [Cou99].
class Emptiness {
 public:
  Emptiness(const BranchGraph& graph, std::uint32_t width, Marks all, Budget& budget)
      : graph_(graph), width_(width), all_(all), budget_(budget), number_(graph.size()) {}

  // members[q]: the states that are q now; `name` the other way round.
  bool operator()(const std::vector<std::uint32_t>& name, const std::vector<std::vector<std::uint32_t>>& members,
                  std::uint32_t start) {
    for (const std::uint32_t v : met_) number_[v] = unseen;
    met_.clear();
    live_.clear();
    roots_.clear();
    calls_.clear();
    enter(start, {});
    while (!calls_.empty()) {
      Call& call = calls_.back();
      const std::vector<std::uint32_t>& same = members[call.vertex / width_];
      if (call.member == same.size()) {
        leave(call.vertex);
        continue;
      }
      const auto branches = graph_.branches(same[call.member] * width_ + call.vertex % width_);
      if (call.branch == branches.size()) {
        ++call.member;
        call.branch = 0;
        continue;
      }
      const Branch& b = branches[call.branch++];
      const std::uint32_t target = name[b.target / width_] * width_ + b.target % width_;
      if (number_[target] == unseen)
        enter(target, b.marks);
      else if (number_[target] != done && closes(number_[target], b.marks))
        return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t unseen = 0, done = UINT32_MAX;
  struct Call {
    std::uint32_t vertex;
    std::size_t member, branch;
  };
  struct Root {
    std::uint32_t number;
    Marks inside, into;  // marks in the component, and on the branch that led into it
  };

  void enter(std::uint32_t vertex, Marks marks) {
    budget_.step();
    met_.push_back(vertex);
    live_.push_back(vertex);
    number_[vertex] = static_cast<std::uint32_t>(live_.size());
    roots_.push_back({number_[vertex], {}, marks});
    calls_.push_back({vertex, 0, 0});
  }
  // A branch back to a vertex whose component is open. Is there a component with all marks now?
  bool closes(std::uint32_t number, Marks marks) {
    while (roots_.back().number > number) {
      marks = marks | roots_.back().inside | roots_.back().into;
      roots_.pop_back();
    }
    roots_.back().inside = roots_.back().inside | marks;
    return roots_.back().inside.includes(all_);
  }
  void leave(std::uint32_t vertex) {
    calls_.pop_back();
    if (roots_.back().number != number_[vertex]) return;
    for (std::size_t i = roots_.back().number; i <= live_.size(); ++i) number_[live_[i - 1]] = done;
    live_.resize(roots_.back().number - 1);
    roots_.pop_back();
  }

  const BranchGraph& graph_;
  std::uint32_t width_;
  Marks all_;
  Budget& budget_;
  std::vector<std::uint32_t> number_;  // by vertex: place in live_, from 1
  std::vector<std::uint32_t> met_;     // vertices with a number
  std::vector<std::uint32_t> live_;    // … of open components, as they were met
  std::vector<Root> roots_;
  std::vector<Call> calls_;
};

// Sets of states of the automaton outside.
class StateSet {
 public:
  explicit StateSet(std::size_t states) : words_(states / 64 + 1, 0) {}
  bool contains(std::uint32_t p) const { return (words_[p / 64] >> p % 64 & 1U) != 0; }
  void add(std::uint32_t p) { words_[p / 64] |= std::uint64_t{1} << p % 64; }
  void add(const StateSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  }
  bool meets(const StateSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if ((words_[i] & other.words_[i]) != 0) return true;
    return false;
  }

 private:
  std::vector<std::uint64_t> words_;
};

class StateMerging {
 public:
  StateMerging(const TransitionRelation& automaton, const TransitionRelation& outside, const std::vector<bool>& colour,
               Budget& budget)
      : colour_(colour),
        width_(static_cast<std::uint32_t>(outside.states())),
        sets_(automaton.acceptance.sets + outside.acceptance.sets),
        graph_(all_pairs(automaton, outside, budget)),
        is_empty_(graph_, width_, Marks::first(sets_), budget),
        start_(automaton.initial * width_ + outside.initial),
        name_(automaton.states()),
        members_(automaton.states()),
        met_(automaton.states(), StateSet(width_)),
        live_(automaton.states(), StateSet(width_)) {
    std::iota(name_.begin(), name_.end(), 0U);
    proved_ = name_;
    for (std::uint32_t q = 0; q < name_.size(); ++q) members_[q] = {q};
    explore();
  }

  // Merges until no two states can be merged, or the budget has run out: then false.
  bool run() {
    try {
      for (std::uint32_t c = 1; c < name_.size(); ++c)
        for (std::uint32_t d = 0; d < c && name_[c] == c; ++d)
          if (name_[d] == d && colour_[c] == colour_[d] && !is_refused(c, d)) merge(c, d);
      return true;
    } catch (const Budget::Exceeded& spent) {
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
      name_ = proved_;
      return false;
    }
  }
  // By state: the least state that this state is merged into, maybe itself.
  const std::vector<std::uint32_t>& names() const { return name_; }
  bool changed() const {
    for (std::uint32_t q = 0; q < name_.size(); ++q)
      if (name_[q] != q) return true;
    return false;
  }

 private:
  // From which pairs a run comes here from the start, and from which a word outside is accepted.
  void explore() {
    const LiveComponents found = live_components(graph_, Acceptance::generalized_buchi(sets_).condition);
    for (std::uint32_t v = 0; v < graph_.size(); ++v)
      if (found.live[v]) live_[v / width_].add(v % width_);
    std::vector<std::uint32_t> stack{start_};
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      StateSet& met = met_[v / width_];
      if (met.contains(v % width_)) continue;
      met.add(v % width_);
      for (const Branch& b : graph_.branches(v)) stack.push_back(b.target);
    }
  }
  bool is_refused(std::uint32_t c, std::uint32_t d) const { return met_[c].meets(live_[d]) || met_[d].meets(live_[c]); }
  void merge(std::uint32_t c, std::uint32_t d) {
    for (const std::uint32_t q : members_[c]) name_[q] = d;
    const std::size_t before = members_[d].size();
    members_[d].insert(members_[d].end(), members_[c].begin(), members_[c].end());
    if (is_empty_(name_, members_, name_[start_ / width_] * width_ + start_ % width_)) {
      proved_ = name_;
      met_[d].add(met_[c]);  // there may be more now: those that are known will do
      live_[d].add(live_[c]);
      return;
    }
    members_[d].resize(before);
    name_ = proved_;
  }

  const std::vector<bool>& colour_;  // only states of one colour are one
  std::uint32_t width_, sets_;
  BranchGraph graph_;
  Emptiness is_empty_;
  std::uint32_t start_;
  std::vector<std::uint32_t> name_, proved_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::vector<StateSet> met_, live_;  // by state
};

// A run takes branches between components finitely often: they need no marks, and with none what they lead to once
// states are one is accepted least.
TransitionRelation without_passing_marks(const TransitionRelation& automaton) {
  const Components found = components(BranchGraph(automaton));
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  return rebuild(automaton, all, [&](std::uint32_t source, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches)
      if (found.of[b.target] != found.of[source]) b.marks = {};
    return branches;
  });
}

}  // namespace

Reduced state_merged(TransitionRelation automaton, const TransitionRelation& outside, MarksOn marks, Budget& budget) {
  Reduced out{std::move(automaton), true};
  std::size_t most = most_vertices;
  try {
    for (; out.complete && out.automaton.states() * outside.states() <= most &&
           out.automaton.acceptance.sets + outside.acceptance.sets <= Marks::most;
         most = most_after_merging) {
      const bool on_states = marks == MarksOn::States;
      const TransitionRelation base = on_states ? out.automaton : without_passing_marks(out.automaton);
      const std::vector<bool> colour = on_states ? marked_states(base) : std::vector<bool>(base.states(), false);
      StateMerging merging(base, outside, colour, budget);
      const bool complete = merging.run();
      if (!merging.changed()) return {std::move(out.automaton), complete};
      out = reduce(united(base, merging.names(), budget), marks, budget);
      out.complete = out.complete && complete;
    }
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    out.complete = false;
  }
  return out;
}

}  // namespace waymark::automata
