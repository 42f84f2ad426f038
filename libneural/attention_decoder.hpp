// One step of a decoder with attention: a query from the last symbols, attention over the words, scores of symbols.
//
//   q = max(0, W_e e + W_x x + b)                  e: the whole sequence; x: the last symbols        [width]
//   α ∝ exp(qᵀ W_a h) over the sequence            c = Σ α h                                         [encoded]
//   score(v) = φ_vᵀ W_s [q; c] + β_v + m_v (uᵀ [q; c] + u₀)
// As [GPLL17, Sec. 3.1], and β: a bias of each symbol. The mark m is ours: it marks symbols that the sequence names,
// and a gate weighs the mark; without marks (m = 0) the scores are theirs. The steps of sequence s are the columns
// [begin_s, end_s). All steps of all sequences take a dozen matrix products.
#pragma once
#include <span>

#include "libneural/multiply.hpp"

namespace waymark::neural {

class AttentionDecoder {
 public:
  struct Sizes {        // of the matrices
    Index encoded = 0;  // of h and e
    Index inputs = 0;   // of x
    Index width = 0;    // of q
    Index symbol = 0;   // of φ
    Index symbols = 0;  // v
  };
  struct Sequences {                 // what is decoded from
    const Matrix* h = nullptr;       // [encoded × elements], element by element, sequence by sequence
    std::span<const Index> h_begin;  // by sequence, and the end
    const Matrix* e = nullptr;       // [encoded × sequences]
    const Matrix* marks = nullptr;   // m [symbols × sequences], or none
    std::span<const Index> begin;    // by sequence, and the end: its choices
    std::span<const Index> said;     // by choice: its column of x; many choices share one
    bool is_attended = false;        // h and e are those of the last `forward` with the same signals
  };
  struct Signals {                       // of one pass, and of the pass back through it
    Matrix from_x;                       // W_x x
    Matrix from_e;                       // W_e e + b
    Matrix keys;                         // W_a h
    Matrix q_and_c;                      // [width + encoded × choices]
    Matrix y;                            // W_s [q; c]
    Matrix gate;                         // [1 × choices]
    std::vector<Matrix> weights;         // α by sequence: [elements × choices]
    Matrix scores;                       // the output [symbols × choices]
    Matrix dscores;                      // set by the caller
    Matrix dq_and_c, dy, dkeys, dh, de;  // ∂ of the above
  };

  // symbols: φ [symbol × symbols or more], which others may read as well.
  AttentionDecoder(Parameters& parameters, const Sizes& sizes, const Block& symbols, const Uniform& uniform);
  const Sizes& sizes() const { return sizes_; }

  // Writes signals.scores.
  void forward(const Parameters& parameters, const Sequences& sequences, const ConstView& x, Signals& signals) const;
  // After `forward`, with ∂scores: adds to the gradients, writes ∂x, signals.dh and signals.de.
  void backward(Parameters& parameters, const Sequences& sequences, const ConstView& x, Signals& signals,
                View dx) const;

 private:
  void attend(const Parameters& parameters, const Sequences& sequences, Signals& signals) const;

  Sizes sizes_;
  Block phi_, from_e_, from_x_, bias_, attend_, say_, symbol_bias_, gate_, gate_bias_;
};

}  // namespace waymark::neural
