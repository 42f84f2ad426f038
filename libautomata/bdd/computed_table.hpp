// A cache of results of operations on decision diagrams.
//
// The cache is direct-mapped: each key has one slot, and a new result replaces the old one. An entry carries the
// generation of its ids, because a collection may reuse ids. forget() starts a new generation in O(1), and older
// entries are then ignored. Source: [BRB90, Sec. 4]; there, a collection scans the table for dead entries.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace waymark::automata {

class ComputedTable {
 public:
  using Arguments = std::array<std::uint32_t, 3>;  // ids of nodes

  // Null: not known. The operation is not 0.
  const std::uint32_t* find(std::uint32_t operation, const Arguments& args) const {
    if (entries_.empty()) return nullptr;
    const Entry& e = entries_[slot(operation, args)];
    // Spelled out: the comparison of arrays is a call of memcmp.
    const bool same = e.operation == operation && e.generation == generation_ && e.args[0] == args[0] &&
                      e.args[1] == args[1] && e.args[2] == args[2];
    return same ? &e.result : nullptr;
  }
  // The table grows with the number of nodes there are.
  void store(std::uint32_t operation, const Arguments& args, std::uint32_t result, std::size_t nodes) {
    if (entries_.empty() || (2 * entries_.size() < nodes && entries_.size() < largest)) grow(nodes);
    entries_[slot(operation, args)] = {operation, generation_, args, result};
  }
  void forget() { ++generation_; }

 private:
  static constexpr std::size_t smallest = 128;      // 3 KiB
  static constexpr std::size_t largest = 1U << 22;  // 96 MiB, reached at eight million nodes

  struct Entry {
    std::uint32_t operation = 0;  // 0: empty
    std::uint32_t generation = 0;
    Arguments args{};
    std::uint32_t result = 0;
  };
  std::size_t slot(std::uint32_t operation, const Arguments& args) const {
    const std::uint64_t key = mix(std::uint64_t{args[0]} << 32U | args[1], 0);
    return mix(key, std::uint64_t{operation} << 32U | args[2]) & (entries_.size() - 1);
  }
  static std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
    a = (a ^ b) * 0x9E37'79B9'7F4A'7C15ULL;
    return a ^ (a >> 32U);
  }
  void grow(std::size_t nodes) {
    std::size_t slots = smallest;
    while (slots < nodes && slots < largest) slots *= 2;
    std::vector<Entry> old(slots);
    old.swap(entries_);
    for (const Entry& e : old)
      if (e.operation != 0 && e.generation == generation_) entries_[slot(e.operation, e.args)] = e;
  }

  std::vector<Entry> entries_;  // a power of two, or empty
  std::uint32_t generation_ = 0;
};

}  // namespace waymark::automata
