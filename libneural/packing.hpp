// Sequences of different lengths in one matrix: column begin(t) + i is element t of sequence i, longest sequence first.
//
// The sequences that reach step t are the first ones. A step of a recurrence over a batch is one product over adjacent
// columns, without padding.
#pragma once
#include <cassert>
#include <span>
#include <vector>

#include "libneural/parameters.hpp"

namespace waymark::neural {

class Packing {
 public:
  // lengths: at least 1 each, none greater than the one before.
  explicit Packing(std::span<const Index> lengths) : lengths_(lengths.begin(), lengths.end()) {
    Index running = sequences();
    for (Index t = 0; running > 0; ++t) {
      while (running > 0 && length(running - 1) <= t) --running;
      begins_.push_back(columns_);
      columns_ += running;
    }
  }

  Index sequences() const { return static_cast<Index>(lengths_.size()); }  // how many
  // Elements of one sequence.
  Index length(Index sequence) const { return lengths_[static_cast<std::size_t>(sequence)]; }
  Index steps() const { return static_cast<Index>(begins_.size()) - 1; }  // elements of the longest sequence
  Index columns() const { return columns_; }                              // elements of all sequences
  Index begin(Index t) const { return begins_[static_cast<std::size_t>(t)]; }
  Index running(Index t) const { return begin(t + 1) - begin(t); }  // sequences longer than t
  Index column(Index sequence, Index t) const {                     // where element t of the sequence stands
    assert(t < length(sequence));
    return begin(t) + sequence;
  }

 private:
  std::vector<Index> lengths_, begins_;  // by sequence; by step, and the end
  Index columns_ = 0;
};

}  // namespace waymark::neural
