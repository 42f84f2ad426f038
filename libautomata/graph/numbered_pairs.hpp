// NumberedPairs numbers pairs of numbers in the order of their first occurrence: states of a product, copies of states.
// The list of pairs serves as the queue of an exploration.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "libautomata/budget.hpp"
#include "libltl/rewriting/pair_memo.hpp"

namespace waymark::automata {

class NumberedPairs {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // what is numbered

  // A new pair is one state of budget.
  std::uint32_t number(std::uint32_t x, std::uint32_t y, Budget& budget) {
    if (const std::uint32_t* known = number_.find(x, y)) return *known;
    budget.state();
    const auto fresh = static_cast<std::uint32_t>(pairs_.size());
    pairs_.emplace_back(x, y);
    number_.store(x, y, fresh);
    return fresh;
  }
  std::size_t size() const { return pairs_.size(); }
  Pair operator[](std::size_t i) const { return pairs_[i]; }  // a copy: numbering moves them
  std::vector<Pair> list() && { return std::move(pairs_); }

 private:
  std::vector<Pair> pairs_;
  ltl::PairMemo<std::uint32_t> number_;
};

}  // namespace waymark::automata
