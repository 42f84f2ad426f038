// States of a program as packed values of its variables, numbered in the order in which they are met.
#pragma once
#include <bit>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

// A state takes 8 bytes for every 64 bits of its variables, and about 40 in the table of the numbers.
class PrismStates {
 public:
  explicit PrismStates(const std::vector<PrismProgram::Variable>& variables) : numbers_(64, Hash{this}, Equal{this}) {
    for (const PrismProgram::Variable& v : variables) {
      const auto bits = static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(v.to - v.from)));
      if (used_ % 64 + bits > 64) used_ = (used_ / 64 + 1) * 64;  // no variable lies in two words
      fields_.push_back({used_ / 64, used_ % 64, v.from, (bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - bits))});
      used_ += bits;
    }
    words_of_a_state_ = used_ / 64 + 1;
  }
  PrismStates(const PrismStates&) = delete;
  PrismStates& operator=(const PrismStates&) = delete;

  std::uint32_t size() const { return static_cast<std::uint32_t>(words_.size() / words_of_a_state_); }

  // The number of the state with these values, which are in range.
  std::uint32_t add(const PrismValues& values) {
    const std::uint32_t fresh = size();
    words_.resize(words_.size() + words_of_a_state_, 0);
    std::uint64_t* const words = words_.data() + std::size_t{fresh} * words_of_a_state_;
    for (std::size_t v = 0; v < fields_.size(); ++v)
      words[fields_[v].word] |= static_cast<std::uint64_t>(values[v] - fields_[v].from) << fields_[v].shift;
    const auto [at, inserted] = numbers_.insert(fresh);
    if (!inserted) words_.resize(words_.size() - words_of_a_state_);
    return *at;
  }

  void read(std::uint32_t state, PrismValues& values) const {  // into values
    values.resize(fields_.size());
    const std::uint64_t* const words = of(state);
    for (std::size_t v = 0; v < fields_.size(); ++v)
      values[v] = static_cast<double>(words[fields_[v].word] >> fields_[v].shift & fields_[v].mask) + fields_[v].from;
  }

 private:
  struct Field {
    std::uint32_t word, shift;
    double from;
    std::uint64_t mask;
  };
  struct Hash {
    const PrismStates* all;
    std::size_t operator()(std::uint32_t state) const {
      std::uint64_t out = 0;
      for (std::uint32_t i = 0; i < all->words_of_a_state_; ++i) {
        out = (out ^ all->of(state)[i]) * 0x9E3779B97F4A7C15ULL;
        out ^= out >> 32U;
      }
      return out;
    }
  };
  struct Equal {
    const PrismStates* all;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      return std::equal(all->of(a), all->of(a) + all->words_of_a_state_, all->of(b));
    }
  };
  const std::uint64_t* of(std::uint32_t state) const { return words_.data() + std::size_t{state} * words_of_a_state_; }

  std::vector<Field> fields_;
  std::uint32_t used_ = 0, words_of_a_state_ = 1;
  std::vector<std::uint64_t> words_;
  std::unordered_set<std::uint32_t, Hash, Equal> numbers_;
};

}  // namespace waymark::plan
