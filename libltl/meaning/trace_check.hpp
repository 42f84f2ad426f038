// Truth of formulas along a finite trajectory: one bit for each position, 64 positions in a machine word.
//
// A column holds the positions of a proposition. The last position is bit 0, so a growing trajectory shifts its columns
// up by one, and truth propagates from low bits to high bits like a carry:
//   X φ    φ << 1                     F φ    φ | −φ                    (from the lowest set bit up)
//   N φ    φ << 1 | 1                 φ U ψ  the carries of (φ | ψ) + ψ
//   ¬ ∧ ∨  the bit operations         φ R ψ  the carries of ψ + (φ & ψ) + 1
// Until is a ripple-carry adder: ψ generates a carry, φ propagates it. Longer words are blocks of 64 with a carry
// between blocks. The adder is that of bit-parallel approximate matching [Mye99]; for LTL on finite words it is ours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/word.hpp"

namespace waymark::ltl {

class Columns {  // a finite word turned on its side
 public:
  explicit Columns(std::size_t propositions) : propositions_(propositions) {}
  Columns(const Trace& word, std::size_t propositions);

  void append(const Letter& letter);              // O(propositions · length / 64)
  void clear();                                   // back to length 0; keeps its memory
  std::size_t length() const { return length_; }  // letters
  std::size_t propositions() const { return propositions_; }
  std::size_t blocks() const { return (length_ + 63) / 64; }  // of 64 positions
  // Block b, one word for each proposition. Position i of n is bit (n−1−i) mod 64 of block (n−1−i) / 64.
  std::span<const std::uint64_t> block(std::size_t b) const {
    return {bits_.data() + b * propositions_, propositions_};
  }

 private:
  std::size_t propositions_, length_ = 0;
  std::vector<std::uint64_t> bits_;  // block after block
};

// Formulas compiled once, checked on many trajectories; what they share is computed once. Checks do not allocate.
// Holds its scratch memory: one for each thread (copies are cheap).
class TraceCheck {
 public:
  explicit TraceCheck(Formula f) : TraceCheck(std::span<const Formula>(&f, 1)) {}
  explicit TraceCheck(std::span<const Formula> formulas);  // of one arena, at least one; none with past operators

  std::size_t formulas() const { return roots_.size(); }  // how many are checked
  std::size_t steps() const { return program_.size(); }   // word operations per block of 64 positions

  // word ⊨ φ. Throws std::invalid_argument on length 0 and when a proposition of the formula has no column.
  bool operator()(const Columns& word);
  // The same for up to 64 positions, straight from the columns by proposition.
  bool operator()(std::span<const std::uint64_t> columns, std::size_t length);
  // verdicts[i]: word ⊨ formula i.
  void check(const Columns& word, std::span<bool> verdicts);
  // truth[b]: block b of formula `which` at every position (bits past the first position mean nothing).
  void at_every_position(const Columns& word, std::size_t which, std::span<std::uint64_t> truth);

 private:
  enum class Code : std::uint8_t {
    Load,
    False,
    True,
    Not,
    And,
    Or,
    Iff,
    Next,
    WeakNext,
    Until,
    Release,
    Finally,
    Globally
  };
  struct Instruction {
    Code code;
    std::uint32_t a = 0, b = 0;  // earlier steps; of a Load the proposition
  };
  struct Run {  // steps of one code in a row: one branch for all of them
    Code code;
    std::uint32_t begin = 0, end = 0;
  };
  static std::size_t arity(Code code);
  std::uint32_t compile(Formula f, std::span<const std::uint32_t> operands);
  std::uint32_t emit(Code code, std::uint32_t a = 0, std::uint32_t b = 0);
  void schedule();
  std::vector<bool> needed() const;
  std::vector<std::uint32_t> order_by_code(const std::vector<bool>& needed) const;
  void demand(std::size_t propositions, std::size_t length) const;
  template <bool Carries>
  void run(const std::uint64_t* columns);
  void run_all(const Columns& word);

  std::vector<Instruction> program_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> roots_;         // the step of each formula
  std::vector<std::uint64_t> value_;         // of each step, in the current block
  std::vector<std::uint64_t> carry_;         // 0 or 1: out of the block before, for each step
  std::vector<std::uint64_t> carry_at_end_;  // what the end of the word carries in
  std::size_t propositions_ = 0;             // columns needed
};

}  // namespace waymark::ltl
