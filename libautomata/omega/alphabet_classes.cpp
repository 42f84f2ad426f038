#include "libautomata/omega/alphabet_classes.hpp"

#include <algorithm>
#include <numeric>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// All diagrams walked together. A path is what one set of letters does in every state.
class Paths {
 public:
  Paths(const TransitionRelation& automaton, std::size_t most, Budget& budget)
      : automaton_(automaton), most_(most), budget_(budget) {}

  bool walk() {
    level_ = automaton_.roots;
    return walk(0);
  }
  std::size_t size() const { return found_; }
  std::uint32_t choice(std::size_t path, std::size_t q) const { return choices_[path * automaton_.states() + q]; }
  // One path for each kind.
  std::vector<std::size_t> distinct() const {
    std::vector<std::size_t> out(found_);
    std::iota(out.begin(), out.end(), std::size_t{0});
    const auto column = [&](std::size_t path) {
      const auto first = choices_.begin() + static_cast<std::ptrdiff_t>(path * automaton_.states());
      return std::pair(first, first + static_cast<std::ptrdiff_t>(automaton_.states()));
    };
    std::sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) {
      const auto [a_first, a_last] = column(a);
      const auto [b_first, b_last] = column(b);
      return std::lexicographical_compare(a_first, a_last, b_first, b_last);
    });
    const auto same = [&](std::size_t a, std::size_t b) {
      const auto [first, last] = column(a);
      return std::equal(first, last, column(b).first);
    };
    out.erase(std::unique(out.begin(), out.end(), same), out.end());
    return out;
  }

 private:
  // `level_` from `at` on: what is left of each diagram.
  bool walk(std::size_t at) {
    const Mtbdd& diagram = automaton_.diagram;
    const std::size_t n = automaton_.states(), next = at + n;
    budget_.step(n / 16 + 1);
    Mtbdd::Variable top = Mtbdd::no_variable;
    for (std::size_t q = at; q < next; ++q) top = std::min(top, diagram.variable(level_[q]));
    if (top == Mtbdd::no_variable) {
      if (++found_ > most_) return false;
      for (std::size_t q = at; q < next; ++q) choices_.push_back(Mtbdd::payload(level_[q]));
      return true;
    }
    if (level_.size() < next + n) level_.resize(next + n);
    for (const bool high : {false, true}) {
      for (std::size_t q = at; q < next; ++q) {
        const Node node = level_[q];
        level_[q + n] = diagram.variable(node) != top ? node : high ? diagram.high(node) : diagram.low(node);
      }
      if (!walk(next)) return false;
    }
    return true;
  }

  const TransitionRelation& automaton_;
  std::size_t most_;
  Budget& budget_;
  std::vector<Node> level_;  // one part for each variable above
  std::size_t found_ = 0;
  std::vector<std::uint32_t> choices_;  // [path · states + q]
};

}  // namespace

std::optional<AlphabetClasses> alphabet_classes(const TransitionRelation& automaton, std::size_t most, Budget& budget) {
  Paths paths(automaton, most, budget);
  if (!paths.walk()) return std::nullopt;
  const std::vector<std::size_t> kinds = paths.distinct();
  AlphabetClasses out{automaton.states(), kinds.size(), {}, automaton.choices};
  out.choice.reserve(out.states * out.kinds);
  for (std::size_t q = 0; q < out.states; ++q)
    for (std::size_t path : kinds) out.choice.push_back(paths.choice(path, q));
  return out;
}

AlphabetClasses reversed(const AlphabetClasses& table, Budget& budget) {
  AlphabetClasses out{table.states, table.kinds, std::vector<std::uint32_t>(table.choice.size()), {}};
  std::vector<std::vector<Branch>> into(table.states);
  for (std::size_t kind = 0; kind < table.kinds; ++kind) {
    budget.step(table.states);
    for (std::uint32_t p = 0; p < table.states; ++p)
      for (const Branch& b : table.choices[table.row(p)[kind]]) into[b.target].push_back({p, b.marks});
    for (std::size_t q = 0; q < table.states; ++q) {
      out.choice[q * table.kinds + kind] = out.choices.intern_sorted(into[q]);  // p ascends, and marks of one p
      into[q].clear();
    }
  }
  return out;
}

}  // namespace waymark::automata
