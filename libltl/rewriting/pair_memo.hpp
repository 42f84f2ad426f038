// What is known of pairs of small numbers: an open-addressed table from (x, y) to a value, for inner loops.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace waymark::ltl {

// (UINT32_MAX, UINT32_MAX) is no key.
template <class Value>
class PairMemo {
 public:
  PairMemo() : slots_(256) {}

  // nullptr when the pair is not there. Valid until the next store().
  const Value* find(std::uint32_t x, std::uint32_t y) const {
    const Slot& slot = slots_[place(slots_, key(x, y))];
    return slot.key == free ? nullptr : &slot.value;
  }
  void store(std::uint32_t x, std::uint32_t y, Value value) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place(slots_, key(x, y))];
    if (slot.key == free) ++used_;
    slot = {key(x, y), value};
  }

 private:
  static constexpr std::uint64_t free = UINT64_MAX;
  struct Slot {
    std::uint64_t key = free;
    Value value{};
  };
  static std::uint64_t key(std::uint32_t x, std::uint32_t y) { return std::uint64_t{x} << 32U | y; }
  static std::size_t place(const std::vector<Slot>& slots, std::uint64_t key) {
    std::uint64_t hash = key * 0x9E37'79B9'7F4A'7C15ULL;
    hash ^= hash >> 32U;
    std::size_t at = hash & (slots.size() - 1);
    while (slots[at].key != free && slots[at].key != key) at = (at + 1) & (slots.size() - 1);
    return at;
  }
  void grow() {
    std::vector<Slot> larger(4 * slots_.size());
    for (const Slot& slot : slots_)
      if (slot.key != free) larger[place(larger, slot.key)] = slot;
    slots_ = std::move(larger);
  }

  std::vector<Slot> slots_;  // a power of two
  std::size_t used_ = 0;
};

}  // namespace waymark::ltl
