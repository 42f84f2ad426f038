// Long short-term memory over packed sequences, in one direction and in both. [HS97], with forget gates [GSC00].
//
//   i, f, o = σ(…), g = tanh(…) of W x + U h₋₁ + b       c = f ∘ c₋₁ + i ∘ g       h = o ∘ tanh c
//   x [inputs × columns]    h [width × columns]    c₋₁ = h₋₁ = 0 at the start of a sequence
// The bias of f starts at 1, so that training starts with cells that keep their memory. [JZS15]
#pragma once
#include "libneural/multiply.hpp"
#include "libneural/packing.hpp"

namespace waymark::neural {

class Lstm {
 public:
  struct Signals {           // of one pass, and of the pass back through it
    Matrix gates;            // [4 width × columns]: i, f, o, g one under the other; going back, ∂ before σ and tanh
    Matrix cell, tanh_cell;  // c, tanh c
    Matrix h;                // the output
    Matrix dh, dcell;        // dh: set by the caller
  };

  Lstm(Parameters& parameters, Index inputs, Index width, const Uniform& uniform);
  Index inputs() const { return input_.columns; }     // rows of x
  Index width() const { return recurrent_.columns; }  // rows of h

  // Writes signals.h.
  void forward(const Parameters& parameters, const Packing& packing, const ConstView& x, Signals& signals) const;
  // After `forward` of the same x, with ∂h in signals.dh, which is used up: adds to the gradients, and writes ∂x.
  void backward(Parameters& parameters, const Packing& packing, const ConstView& x, Signals& signals, View dx) const;

 private:
  Block input_, recurrent_, bias_;  // W [4 width × inputs], U [4 width × width], b
};

// One LSTM reads each sequence forwards, one backwards. [SP97]
//   h [2 width × columns]: forwards above backwards;  last [2 width × sequences]: what each has read of it all
class BidirectionalLstm {
 public:
  struct Signals {                      // of both directions
    Lstm::Signals forwards, backwards;  // of each
    Matrix reversed, dreversed;         // the input, each sequence from its end
    Matrix h, last;                     // the outputs
    Matrix dh, dlast;                   // set by the caller
  };

  BidirectionalLstm(Parameters& parameters, Index inputs, Index width, const Uniform& uniform);
  Index width() const { return 2 * forwards_.width(); }  // rows of h of one pass over both directions

  // Writes signals.h and signals.last.
  void forward(const Parameters& parameters, const Packing& packing, const ConstView& x, Signals& signals) const;
  // After `forward`, with ∂ in signals.dh and signals.dlast: adds to the gradients.
  void backward(Parameters& parameters, const Packing& packing, const ConstView& x, Signals& signals, View dx) const;

 private:
  Lstm forwards_, backwards_;
};

}  // namespace waymark::neural
