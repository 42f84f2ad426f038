// The symbolic transition relation of a nondeterministic ω-automaton under construction.
//
// δ(q, ·) is one MTBDD whose terminals are choices: interned sets of branches (marks, target), the empty set where no
// run continues. A letter determines a choice, and the run picks a branch. There are no lists of letters or cubes.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/omega/acceptance.hpp"

namespace waymark::automata {

struct Branch {              // one way on
  std::uint32_t target = 0;  // the next state
  Marks marks;               // of the edge
  friend auto operator<=>(const Branch&, const Branch&) = default;
};

// Interned sets of branches. Id 0 is the empty set.
class Choices {
 public:
  static constexpr std::uint32_t none = 0;  // the empty choice: no run continues
  Choices();
  std::uint32_t intern(std::vector<Branch> branches);             // any order, duplicates allowed
  std::uint32_t intern_sorted(std::span<const Branch> branches);  // each once
  std::span<const Branch> operator[](std::uint32_t id) const {    // sorted by target, then marks
    return {branches_.data() + begin_[id], begin_[id + 1] - begin_[id]};
  }
  std::size_t size() const { return begin_.size() - 1; }

 private:
  void grow();

  std::vector<Branch> branches_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> table_;  // open-addressed over ids + 1, 0 is free; a power of two
};

struct TransitionRelation {
  Mtbdd diagram;                   // terminals are ids of choices
  Choices choices;                 // by id
  std::vector<Mtbdd::Node> roots;  // δ(q, ·)
  std::uint32_t initial = 0;       // the state where words begin
  Acceptance acceptance;           // over the marks of the branches

  std::size_t states() const { return roots.size(); }  // numbered from 0
};

// The distinct choices below a root, in order of first appearance (false before true), the empty one included; and the
// distinct branches of all of them, sorted by target, then marks. For many states of one automaton, which must stay.
class ChoiceLists {
 public:
  explicit ChoiceLists(const TransitionRelation& automaton);
  std::span<const std::uint32_t> of(std::uint32_t q);  // valid until the next call
  std::vector<Branch> branches(std::uint32_t q);       // of all letters together

 private:
  const TransitionRelation& automaton_;
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> node_seen_, choice_seen_;  // in which round
  std::vector<Mtbdd::Node> stack_;
  std::vector<std::uint32_t> found_;
};
// Of all letters together, each once.
std::vector<std::uint32_t> choices_of(const TransitionRelation& automaton, std::uint32_t q);
std::vector<Branch> branches_of(const TransitionRelation& automaton, std::uint32_t q);
// Distinct (source, marks, target): the edges after merging. O(states · diagram).
std::size_t count_edges(const TransitionRelation& automaton);
// No choice has two branches.
bool is_deterministic(const TransitionRelation& automaton);
// … and none is empty.
bool is_complete(const TransitionRelation& automaton);

// Copies roots of one automaton into another one, choices changed: leaf(choice) is asked once a root and gives the id
// of a choice of the other one. The low side is copied first. Both automata must stay.
class RootCopier {
 public:
  RootCopier(const TransitionRelation& from, TransitionRelation& to)
      : from_(from), to_(to), nodes_(from.diagram.size()), leaves_(from.choices.size()) {}
  // Terminals become what `leaf` says.
  template <class Leaf>
  Mtbdd::Node copy(Mtbdd::Node root, const Leaf& leaf) {
    ++round_;
    return image(root, leaf);
  }

 private:
  struct Known {
    std::uint32_t round = 0;
    Mtbdd::Node image;
  };
  template <class Leaf>
  Mtbdd::Node image(Mtbdd::Node n, const Leaf& leaf) {
    const bool terminal = Mtbdd::is_terminal(n);
    Known& known = terminal ? leaves_[Mtbdd::payload(n)] : nodes_[n.id];
    if (known.round == round_) return known.image;
    Mtbdd::Node made;
    if (terminal) {
      made = Mtbdd::terminal(leaf(Mtbdd::payload(n)));
    } else {
      const Mtbdd::Node low = image(from_.diagram.low(n), leaf), high = image(from_.diagram.high(n), leaf);
      made = to_.diagram.make(from_.diagram.variable(n), low, high);
    }
    known = {round_, made};
    return made;
  }

  const TransitionRelation& from_;
  TransitionRelation& to_;
  std::uint32_t round_ = 0;
  std::vector<Known> nodes_, leaves_;
};

// The automaton with new branches: `change` is asked once for each choice of each state in `kept` (indices of the old
// automaton, its new state i is kept[i]) and gives branches over new states. The initial state and the acceptance are
// copied and are the caller's to change.
using ChangeChoice = std::function<std::vector<Branch>(std::uint32_t source, std::span<const Branch> choice)>;
TransitionRelation rebuild(const TransitionRelation& automaton, std::span<const std::uint32_t> kept,
                           const ChangeChoice& change);

// Two roots joined: on each letter the branches of both. The operation belongs to this function alone.
Mtbdd::Node unite(TransitionRelation& automaton, Mtbdd::Operation operation, Mtbdd::Node f, Mtbdd::Node g,
                  Budget& budget);

// The reachable states, numbered breadth first from the initial state (which becomes 0), targets in the order of the
// diagram, false before true, and of a choice by (marks, old number); nodes and choices made afresh in that order.
TransitionRelation canonical(const TransitionRelation& automaton);
// Of two in canonical numbering: the same but for the names of states and nodes. O(size).
bool identical(const TransitionRelation& a, const TransitionRelation& b);

}  // namespace waymark::automata
