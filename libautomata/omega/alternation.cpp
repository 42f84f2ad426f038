#include "libautomata/omega/alternation.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "libautomata/bdd/boolean.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
using Set = std::vector<std::uint32_t>;  // of states, sorted

struct Owed {
  Set all, unmarked;  // S and O
  friend auto operator<=>(const Owed&, const Owed&) = default;
};

Set united(const Set& a, const Set& b) {
  Set out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

bool includes(const Owed& large, const Owed& small) {
  return std::includes(large.all.begin(), large.all.end(), small.all.begin(), small.all.end()) &&
         std::includes(large.unmarked.begin(), large.unmarked.end(), small.unmarked.begin(), small.unmarked.end());
}

// Alternatives none of which includes another.
using Alternatives = std::vector<Owed>;

void add(Alternatives& all, Owed fresh) {
  for (const Owed& known : all)
    if (includes(fresh, known)) return;
  all.erase(std::remove_if(all.begin(), all.end(), [&](const Owed& known) { return includes(known, fresh); }),
            all.end());
  all.push_back(std::move(fresh));
}

template <class Value>
class Interned {
 public:
  std::uint32_t id(const Value& value) {
    const auto [at, fresh] = ids_.try_emplace(value, static_cast<std::uint32_t>(values_.size()));
    if (fresh) values_.push_back(&at->first);
    return at->second;
  }
  const Value& operator[](std::uint32_t id) const { return *values_[id]; }
  std::size_t size() const { return values_.size(); }

 private:
  std::map<Value, std::uint32_t> ids_;
  std::vector<const Value*> values_;
};

class Breakpoints {
 public:
  Breakpoints(AlternatingBuchi automaton, Budget& budget)
      : automaton_(std::move(automaton)),
        budget_(budget),
        step_(2, std::vector<Node>(automaton_.edges.size())),
        done_(2, std::vector<bool>(automaton_.edges.size(), false)),
        join_(automaton_.diagram.operation()) {}

  TransitionRelation build() {
    Alternatives starts;
    for (const auto& start : automaton_.starts) {
      Set all = start;
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      add(starts, {all, all});
    }
    out_.acceptance = Acceptance::buchi();
    if (starts.size() == 1) {
      number(starts.front());
    } else {
      number({{UINT32_MAX}, {}});  // a fresh initial state, which is none of the automaton's
    }
    std::vector<Node> roots;
    for (std::uint32_t i = 0; i < states_.size(); ++i)
      roots.push_back(i == 0 && starts.size() != 1 ? successors_of(starts) : successors(states_[i]));
    const auto leaf = [&](std::uint32_t payload) { return Mtbdd::terminal(choices_.at(payload)); };
    out_.roots = out_.diagram.import(automaton_.diagram, roots, leaf, [](Mtbdd::Variable v) { return v; });
    return std::move(out_);
  }

 private:
  std::uint32_t number(const Owed& owed) {
    const std::size_t before = states_.size();
    const std::uint32_t id = states_.id(owed);
    if (states_.size() != before) budget_.state();
    return id;
  }

  // What one state may lead to; payloads are alternatives. `unmarked`: it has not met a mark yet.
  Node step(std::uint32_t state, bool unmarked) {
    if (done_[unmarked][state]) return step_[unmarked][state];
    Node all = Mtbdd::terminal(alternatives_.id({}));
    for (const AlternatingBuchi::Edge& edge : automaton_.edges[state]) {
      const Owed fresh{edge.targets, unmarked && !edge.marked ? edge.targets : Set{}};
      const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
        if (n[0] == Boolean::constant(false)) return n[1];
        if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
        Alternatives more = alternatives_[Mtbdd::payload(n[1])];
        add(more, fresh);
        std::sort(more.begin(), more.end());
        return Mtbdd::terminal(alternatives_.id(more));
      };
      all = automaton_.diagram.apply(automaton_.diagram.operation(), std::array{edge.label, all}, decide);
    }
    done_[unmarked][state] = true;
    return step_[unmarked][state] = all;
  }

  // Both must be met: every alternative of one with every one of the other.
  std::uint32_t joined(std::uint32_t f, std::uint32_t g) {
    Alternatives out;
    for (const Owed& a : alternatives_[f])
      for (const Owed& b : alternatives_[g]) {
        budget_.step();
        add(out, {united(a.all, b.all), united(a.unmarked, b.unmarked)});
      }
    std::sort(out.begin(), out.end());
    return alternatives_.id(out);
  }

  Node together(const Owed& owed) {
    Node all = Mtbdd::terminal(alternatives_.id({Owed{}}));
    for (std::uint32_t state : owed.all) {
      const bool unmarked = std::binary_search(owed.unmarked.begin(), owed.unmarked.end(), state);
      const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
        if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
        return Mtbdd::terminal(joined(Mtbdd::payload(n[0]), Mtbdd::payload(n[1])));
      };
      all = automaton_.diagram.apply(join_, std::array{all, step(state, unmarked)}, decide);
    }
    return all;
  }

  // Payloads become choices of the result; a breakpoint starts O anew.
  Node successors(const Owed& owed) {
    const Node alternatives = together(owed);
    return map_terminals(alternatives);
  }
  Node successors_of(const Alternatives& starts) {
    Node all = Mtbdd::terminal(alternatives_.id({}));
    const Mtbdd::Operation unite = automaton_.diagram.operation();
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      Alternatives both = alternatives_[Mtbdd::payload(n[0])];
      for (const Owed& more : alternatives_[Mtbdd::payload(n[1])]) add(both, more);
      std::sort(both.begin(), both.end());
      return Mtbdd::terminal(alternatives_.id(both));
    };
    for (const Owed& start : starts) all = automaton_.diagram.apply(unite, std::array{all, together(start)}, decide);
    return map_terminals(all);
  }

  Node map_terminals(Node alternatives) {
    std::vector<Node> stack{alternatives};
    for (Node n : automaton_.diagram.reachable(stack)) {
      stack.push_back(automaton_.diagram.low(n));
      stack.push_back(automaton_.diagram.high(n));
    }
    for (Node n : stack)
      if (Mtbdd::is_terminal(n)) choice(Mtbdd::payload(n));
    return alternatives;
  }

  void choice(std::uint32_t payload) {
    if (choices_.contains(payload)) return;
    const Alternatives alternatives = alternatives_[payload];
    std::vector<Branch> branches;
    for (const Owed& owed : alternatives) {
      const bool breakpoint = owed.unmarked.empty();
      branches.push_back(
          {number({owed.all, breakpoint ? owed.all : owed.unmarked}), breakpoint ? Marks::of(0) : Marks()});
    }
    choices_.emplace(payload, out_.choices.intern(std::move(branches)));
  }

  AlternatingBuchi automaton_;
  Budget& budget_;
  Interned<Alternatives> alternatives_;
  Interned<Owed> states_;
  std::vector<std::vector<Node>> step_;  // by `unmarked`, then state
  std::vector<std::vector<bool>> done_;
  Mtbdd::Operation join_;
  std::map<std::uint32_t, std::uint32_t> choices_;  // of alternatives
  TransitionRelation out_;
};

}  // namespace

TransitionRelation without_alternation(AlternatingBuchi automaton, Budget& budget) {
  return Breakpoints(std::move(automaton), budget).build();
}

}  // namespace waymark::automata
