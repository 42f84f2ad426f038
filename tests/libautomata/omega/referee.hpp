// What an automaton accepts, by definition: the set of marks met infinitely often is tried out, every one of them.
#pragma once
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "libautomata/omega/alternation.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/word.hpp"

namespace waymark::automata::referee {

using Place = std::pair<std::uint32_t, std::size_t>;  // state, position in the lasso

struct Move {
  Place from, to;
  Marks marks;
};

inline std::vector<Move> moves(const Automaton& automaton, const ltl::Lasso& word) {
  std::vector<Move> out;
  std::set<Place> seen{{automaton.initial().index, 0}};
  std::vector<Place> queue(seen.begin(), seen.end());
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Place from = queue[i];
    for (const Branch& b : automaton.next(StateId{from.first}, word[from.second])) {
      const Place to{b.target, word.successor(from.second)};
      out.push_back({from, to, b.marks});
      if (seen.insert(to).second) queue.push_back(to);
    }
  }
  return out;
}

// The places that a place reaches by moves whose marks are all in `allowed`.
inline std::set<Place> reached(const std::vector<Move>& all, Place from, Marks allowed) {
  std::set<Place> seen;
  bool grew = true;
  while (grew) {
    grew = false;
    for (const Move& m : all)
      if (allowed.includes(m.marks) && (m.from == from || seen.contains(m.from)))
        grew = seen.insert(m.to).second || grew;
  }
  return seen;
}

// Is there a cycle whose marks are exactly these?
inline bool can_repeat(const std::vector<Move>& all, Marks exactly) {
  std::set<Place> places;
  for (const Move& m : all) places.insert(m.from);
  for (const Place& place : places) {
    const std::set<Place> ahead = reached(all, place, exactly);
    if (!ahead.contains(place)) continue;
    Marks met;
    for (const Move& m : all)
      if (exactly.includes(m.marks) && (m.from == place || ahead.contains(m.from)) &&
          (m.to == place || reached(all, m.to, exactly).contains(place)))
        met = met | m.marks;
    if (met == exactly) return true;
  }
  return false;
}

inline bool accepts(const Automaton& automaton, const ltl::Lasso& word) {
  const std::vector<Move> all = moves(automaton, word);
  for (std::uint64_t bits = 0; bits < std::uint64_t{1} << automaton.acceptance().sets; ++bits)
    if (automaton.acceptance().condition.holds(Marks::from_bits(bits)) && can_repeat(all, Marks::from_bits(bits)))
      return true;
  return false;
}

// An alternating Büchi automaton on a lasso, as νX.μY. ∃ edge ∀ targets: in X when marked, else in Y.
inline bool accepts(const AlternatingBuchi& automaton, const ltl::Lasso& word) {
  const std::size_t states = automaton.edges.size();
  using Table = std::vector<std::vector<bool>>;
  const auto can = [&](std::uint32_t q, std::size_t i, const Table& x, const Table& y) {
    for (const AlternatingBuchi::Edge& edge : automaton.edges[q]) {
      const auto in = [&](Mtbdd::Variable v) { return word[i].contains({v}); };
      if (Mtbdd::payload(automaton.diagram.evaluate(edge.label, in)) == 0) continue;
      bool all = true;
      for (std::uint32_t target : edge.targets) all = all && (edge.marked ? x : y)[target][word.successor(i)];
      if (all) return true;
    }
    return false;
  };
  Table x(states, std::vector<bool>(word.size(), true));
  for (bool shrank = true; shrank;) {
    Table y(states, std::vector<bool>(word.size(), false));
    for (bool grew = true; grew;) {
      grew = false;
      for (std::uint32_t q = 0; q < states; ++q)
        for (std::size_t i = 0; i < word.size(); ++i)
          if (!y[q][i] && can(q, i, x, y)) grew = y[q][i] = true;
    }
    shrank = x != y;
    x = y;
  }
  for (const auto& start : automaton.starts) {
    bool all = true;
    for (std::uint32_t q : start) all = all && x[q][0];
    if (all) return true;
  }
  return false;
}

}  // namespace waymark::automata::referee
