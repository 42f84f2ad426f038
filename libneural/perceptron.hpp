// A multi-layer perceptron: dense layers with ReLU between them, none after the last.
//
//   x [features × batch] → hidden … → outputs [outputs × batch]
// The layers refer to the parameters. The caller owns the signals of one pass, made once for a batch size, so training
// allocates nothing.
#pragma once
#include <span>
#include <vector>

#include "libneural/dense.hpp"

namespace waymark::neural {

class Perceptron {
 public:
  struct Signals {                  // of one forward pass, and of the backward pass through it
    std::vector<Matrix> outputs;    // of each layer, behind its ReLU
    std::vector<Matrix> gradients;  // of the same
  };

  // sizes: features, hidden layers, outputs; at least two.
  Perceptron(Parameters& parameters, std::span<const Index> sizes, const Uniform& uniform);

  Index inputs() const { return layers_.front().weight.columns; }  // features
  Index outputs() const { return layers_.back().weight.rows; }     // of the last layer
  Signals signals(Index batch) const;                              // room for a pass over that many examples

  // The outputs, which stay in `signals`. x has at most as many columns as the signals were made for; the columns
  // behind them mean nothing.
  const Matrix& forward(const Parameters& parameters, const ConstView& x, Signals& signals) const;
  // After `forward` of the same x, with ∂outputs in signals.gradients.back(): adds to the gradients of the parameters.
  void backward(Parameters& parameters, const ConstView& x, Signals& signals) const;
  void backward(Parameters& parameters, const ConstView& x, Signals& signals, View dx) const;  // and ∂x

 private:
  void backward_to_first(Parameters& parameters, Index n, Signals& signals) const;
  std::vector<Dense> layers_;
};

}  // namespace waymark::neural
