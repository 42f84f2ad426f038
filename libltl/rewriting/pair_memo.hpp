// What is known of pairs of small numbers: an open-addressed table from (x, y) to a value, for inner loops. It is
// emptied in O(1): a slot is taken in the current round only.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace waymark::ltl {

template <class Value>
class PairMemo {
 public:
  void clear() {
    used_ = 0;
    if (++round_ == 0) *this = {};
  }
  // nullptr when the pair is not there. Valid until the next insert() or store().
  const Value* find(std::uint32_t x, std::uint32_t y) const {
    const Slot& slot = slots_[place(slots_, key(x, y))];
    return slot.round == round_ ? &slot.value : nullptr;
  }
  bool insert(std::uint32_t x, std::uint32_t y, Value value = {}) {  // false: the pair is there, and stays
    Slot& slot = slot_of(x, y);
    if (slot.round == round_) return false;
    slot = {key(x, y), round_, value};
    ++used_;
    return true;
  }
  void store(std::uint32_t x, std::uint32_t y, Value value) {
    Slot& slot = slot_of(x, y);
    if (slot.round != round_) ++used_;
    slot = {key(x, y), round_, value};
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t round = 0;
    Value value{};
  };
  static std::uint64_t key(std::uint32_t x, std::uint32_t y) { return std::uint64_t{x} << 32U | y; }
  std::size_t place(const std::vector<Slot>& slots, std::uint64_t key) const {
    std::uint64_t hash = key * 0x9E37'79B9'7F4A'7C15ULL;
    hash ^= hash >> 32U;
    std::size_t at = hash & (slots.size() - 1);
    while (slots[at].round == round_ && slots[at].key != key) at = (at + 1) & (slots.size() - 1);
    return at;
  }
  Slot& slot_of(std::uint32_t x, std::uint32_t y) {  // of the pair, or free
    if (2 * (used_ + 1) > slots_.size()) grow();
    return slots_[place(slots_, key(x, y))];
  }
  void grow() {
    std::vector<Slot> larger(4 * slots_.size());
    for (const Slot& slot : slots_)
      if (slot.round == round_) larger[place(larger, slot.key)] = slot;
    slots_ = std::move(larger);
  }

  std::vector<Slot> slots_ = std::vector<Slot>(64);  // a power of two
  std::uint32_t round_ = 1;
  std::size_t used_ = 0;
};

}  // namespace waymark::ltl
