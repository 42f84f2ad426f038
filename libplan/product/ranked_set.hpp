// A set of numbers that knows how many members come before each: two bits a number there could be, and an eighth of a
// bit a member.
#pragma once
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace waymark::plan {

class RankedSet {
 public:
  explicit RankedSet(std::uint64_t size) : words_(size / 64 + 1) {}
  bool contains(std::uint64_t i) const { return ((words_[i / 64].bits >> (i % 64)) & 1U) != 0; }  // i ∈ this
  bool insert(std::uint64_t i) {                                                                  // false: it was there
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    if ((words_[i / 64].bits & bit) != 0) return false;
    words_[i / 64].bits |= bit;
    return true;
  }
  bool insert_together(std::uint64_t i) {  // the same, by several threads at once; of those that insert i, one
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    std::atomic_ref word(words_[i / 64].bits);
    return (word.load(std::memory_order_relaxed) & bit) == 0 &&
           (word.fetch_or(bit, std::memory_order_relaxed) & bit) == 0;
  }
  void rank();                                 // after the last insert
  std::uint32_t rank(std::uint64_t i) const {  // members before i
    const Word& word = words_[i / 64];
    return word.before + static_cast<std::uint32_t>(std::popcount(word.bits & ((std::uint64_t{1} << (i % 64)) - 1)));
  }
  std::uint64_t select(std::uint32_t rank) const;  // the member with that rank: O(1) where members stand close
  template <class Visit>                           // visit(member), ascending from `first` on, until it says false
  void for_each(std::uint64_t first, Visit&& visit) const {
    std::uint64_t skip = ~std::uint64_t{0} << (first % 64);
    for (std::uint64_t w = first / 64; w < words_.size(); ++w, skip = ~std::uint64_t{0})
      for (std::uint64_t bits = words_[w].bits & skip; bits != 0; bits &= bits - 1)
        if (!visit(64 * w + static_cast<std::uint64_t>(std::countr_zero(bits)))) return;
  }

 private:
  struct Word {
    std::uint64_t bits = 0;
    std::uint32_t before = 0;
  };
  std::vector<Word> words_;
  static constexpr std::uint32_t stride = 512;
  std::vector<std::uint64_t> every_;  // of every 512th member: its word
};

}  // namespace waymark::plan
