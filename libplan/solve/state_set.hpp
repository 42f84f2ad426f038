// A set of states, by their numbers: a bit each.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace waymark::plan {

class StateSet {
 public:
  static constexpr std::uint32_t in_a_word = 64;  // numbers from a multiple of this on

  StateSet() = default;
  explicit StateSet(std::size_t states, bool all = false) : size_(states), words_(states / in_a_word + 1) {
    for (std::size_t w = 0; all && w < words_.size(); ++w) put(w, ~std::uint64_t{0});
    if (all) words_.back() &= bit(states % in_a_word) - 1;
  }
  StateSet(const StateSet& other) : size_(other.size_), words_(other.words_.size()) {
    for (std::size_t w = 0; w < words_.size(); ++w) put(w, other.word(w));
  }
  StateSet& operator=(const StateSet& other) {  // copies its members
    if (this != &other) *this = StateSet(other);
    return *this;
  }
  StateSet(StateSet&&) noexcept = default;
  StateSet& operator=(StateSet&&) noexcept = default;
  ~StateSet() = default;

  std::size_t size() const { return size_; }  // states there are
  [[gnu::always_inline]] bool operator[](std::size_t i) const {
    return (word(i / in_a_word) & bit(i)) != 0;
  }  // i ∈ this

  // By one thread at a time, as far as numbers of one word are concerned.
  void insert(std::uint32_t i) { put(i / in_a_word, word(i / in_a_word) | bit(i)); }
  void erase(std::uint32_t i) { put(i / in_a_word, word(i / in_a_word) & ~bit(i)); }
  void set(std::uint32_t i, bool member) { member ? insert(i) : erase(i); }

  // By several threads at once: true for the one that changed the set.
  bool join(std::uint32_t i) {
    return (words_[i / in_a_word].fetch_or(bit(i), std::memory_order_relaxed) & bit(i)) == 0;
  }
  // Of two threads that take a state out each and look for the other's then, one at least finds it gone.
  bool leave(std::uint32_t i) {
    const bool changed = (words_[i / in_a_word].fetch_and(~bit(i), std::memory_order_relaxed) & bit(i)) != 0;
    std::atomic_thread_fence(std::memory_order_seq_cst);
    return changed;
  }

  StateSet& operator-=(const StateSet& other) {  // both of the same size
    for (std::size_t w = 0; w < words_.size(); ++w) put(w, word(w) & ~other.word(w));
    return *this;
  }
  friend bool operator==(const StateSet& a, const StateSet& b) {
    const auto same = [](const Word& v, const Word& w) {
      return v.load(std::memory_order_relaxed) == w.load(std::memory_order_relaxed);
    };
    return a.size_ == b.size_ && std::equal(a.words_.begin(), a.words_.end(), b.words_.begin(), b.words_.end(), same);
  }

 private:
  using Word = std::atomic<std::uint64_t>;
  static std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << (i % in_a_word); }
  std::uint64_t word(std::size_t w) const { return words_[w].load(std::memory_order_relaxed); }
  void put(std::size_t w, std::uint64_t bits) { words_[w].store(bits, std::memory_order_relaxed); }

  std::size_t size_ = 0;
  std::vector<Word> words_;
};

}  // namespace waymark::plan
