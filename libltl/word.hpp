// Letters and words: formulas are evaluated on words.
//
// A letter is a set of propositions a ⊆ AP, stored as a bit set over Proposition::index.
// A Trace is a finite, non-empty word. A Lasso is the infinite word u·vʷ with v non-empty.
#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "libltl/vocabulary.hpp"

namespace waymark::ltl {

class Letter {
 public:
  Letter() = default;
  Letter(std::initializer_list<Proposition> members) {
    for (Proposition p : members) insert(p);
  }

  bool contains(Proposition p) const {  // p ∈ this
    const std::size_t block = p.index / 64;
    if (block == 0) return ((first_ >> p.index) & 1U) != 0;
    return block <= rest_.size() && ((rest_[block - 1] >> (p.index % 64)) & 1U) != 0;
  }
  void insert(Proposition p);                // this ∪ {p}
  void erase(Proposition p);                 // this ∖ {p}
  void insert_all(const Letter& other);      // this ∪ other
  bool includes(const Letter& other) const;  // other ⊆ this
  std::vector<Proposition> members() const;  // ascending
  bool empty() const { return first_ == 0 && rest_.empty(); }
  // Propositions 64·i … 64·i+63 as bits; 0 past the end.
  std::uint64_t block(std::size_t i) const {
    if (i == 0) return first_;
    return i <= rest_.size() ? rest_[i - 1] : 0;
  }

  friend bool operator==(const Letter&,
                         const Letter&) = default;  // rest_ never ends in 0: equal sets, equal bits

 private:
  std::uint64_t first_ = 0;          // propositions 0 … 63, without allocation
  std::vector<std::uint64_t> rest_;  // 64 …, no trailing zero blocks
};

class Trace {  // a finite word
 public:
  explicit Trace(std::vector<Letter> letters);  // throws std::invalid_argument when empty
  std::size_t size() const { return letters_.size(); }
  const Letter& operator[](std::size_t i) const { return letters_[i]; }
  auto begin() const { return letters_.begin(); }
  auto end() const { return letters_.end(); }
  friend bool operator==(const Trace&, const Trace&) = default;

 private:
  std::vector<Letter> letters_;
};

class Lasso {  // an infinite word u·vʷ
 public:
  Lasso(std::vector<Letter> prefix,
        std::vector<Letter> cycle);                       // throws std::invalid_argument on an empty cycle
  std::size_t size() const { return letters_.size(); }    // |u| + |v|
  std::size_t loop_start() const { return loop_start_; }  // |u|
  const Letter& operator[](std::size_t i) const { return letters_[i]; }
  // The position read after i, 0 ≤ i < size(); the last one leads back to loop_start().
  std::size_t successor(std::size_t i) const { return i + 1 < letters_.size() ? i + 1 : loop_start_; }
  friend bool operator==(const Lasso&, const Lasso&) = default;

 private:
  std::vector<Letter> letters_;  // u v
  std::size_t loop_start_;
};

// "{a, b}; {}; {b}" and "{a}; ({b}; {})ʷ": for messages and failing cases, ready to paste.
std::string show(const Letter& letter, const Vocabulary& vocabulary);
std::string show(const Trace& word, const Vocabulary& vocabulary);
std::string show(const Lasso& word, const Vocabulary& vocabulary);

}  // namespace waymark::ltl
