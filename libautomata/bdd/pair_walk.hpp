// Two diagrams walked together: to which pairs of terminals do letters lead?
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/budget.hpp"

namespace waymark::automata {

// A set of pairs that is emptied in O(1). Open-addressed; a slot is taken in the current round only.
class SeenPairs {
 public:
  void clear() {
    ++round_;
    used_ = 0;
  }
  bool insert(std::uint32_t x, std::uint32_t y) {  // false: it is there
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place(slots_, x, y)];
    if (slot.round == round_) return false;
    slot = {x, y, round_};
    ++used_;
    return true;
  }

 private:
  struct Slot {
    std::uint32_t x = 0, y = 0;
    std::uint64_t round = 0;
  };
  std::size_t place(const std::vector<Slot>& slots, std::uint32_t x, std::uint32_t y) const {
    std::uint64_t hash = (std::uint64_t{x} << 32U | y) * 0x9E37'79B9'7F4A'7C15ULL;
    hash ^= hash >> 32U;
    std::size_t at = hash & (slots.size() - 1);
    while (slots[at].round == round_ && (slots[at].x != x || slots[at].y != y))
      at = (at + 1) & (slots.size() - 1);
    return at;
  }
  void grow() {
    std::vector<Slot> larger(2 * slots_.size());
    for (const Slot& slot : slots_)
      if (slot.round == round_) larger[place(larger, slot.x, slot.y)] = slot;
    slots_ = std::move(larger);
  }

  std::vector<Slot> slots_ = std::vector<Slot>(32);  // a power of two
  std::uint64_t round_ = 1;
  std::size_t used_ = 0;
};

class PairWalk {
 public:
  using Node = Mtbdd::Node;
  // Over the same variables; one manager or two.
  PairWalk(const Mtbdd& first, const Mtbdd& second, Budget& budget)
      : first_(first), second_(second), budget_(budget) {}

  // meet(payload, payload) for each pair of terminals below the roots, once. One step of budget per pair of nodes.
  template <class Meet>
  void from(Node x, Node y, const Meet& meet) {
    seen_.clear();
    visit(x, y, meet);
  }

 private:
  template <class Meet>
  void visit(Node x, Node y, const Meet& meet) {
    if (!seen_.insert(x.id, y.id)) return;
    budget_.step();
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) return meet(Mtbdd::payload(x), Mtbdd::payload(y));
    const Mtbdd::Variable top = std::min(first_.variable(x), second_.variable(y));
    const auto side = [&](const Mtbdd& diagram, Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    for (const bool high : {false, true}) visit(side(first_, x, high), side(second_, y, high), meet);
  }

  const Mtbdd &first_, &second_;
  Budget& budget_;
  SeenPairs seen_;  // of nodes
};

}  // namespace waymark::automata
