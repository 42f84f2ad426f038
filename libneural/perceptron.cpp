#include "libneural/perceptron.hpp"

#include <cassert>

namespace waymark::neural {

Perceptron::Perceptron(Parameters& parameters, std::span<const Index> sizes, const Uniform& uniform) {
  assert(sizes.size() >= 2);
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
    layers_.push_back(add_dense(parameters, sizes[i], sizes[i + 1], uniform));
}

Perceptron::Signals Perceptron::signals(Index batch) const {
  Signals made;
  for (const Dense& layer : layers_) made.outputs.emplace_back(Matrix::Zero(layer.weight.rows, batch));
  made.gradients = made.outputs;
  return made;
}

const Matrix& Perceptron::forward(const Parameters& parameters, const ConstView& x, Signals& signals) const {
  const Index n = x.cols();
  assert(n <= signals.outputs[0].cols());
  neural::forward(parameters, layers_[0], x, signals.outputs[0].leftCols(n));
  for (std::size_t i = 1; i < layers_.size(); ++i) {
    relu(signals.outputs[i - 1].leftCols(n));
    neural::forward(parameters, layers_[i], signals.outputs[i - 1].leftCols(n), signals.outputs[i].leftCols(n));
  }
  return signals.outputs.back();
}

void Perceptron::backward_to_first(Parameters& parameters, Index n, Signals& signals) const {
  for (std::size_t i = layers_.size() - 1; i > 0; --i) {
    const auto y = signals.outputs[i - 1].leftCols(n);
    neural::backward(parameters, layers_[i], y, signals.gradients[i].leftCols(n), signals.gradients[i - 1].leftCols(n));
    relu_backward(y, signals.gradients[i - 1].leftCols(n));
  }
}

void Perceptron::backward(Parameters& parameters, const ConstView& x, Signals& signals) const {
  backward_to_first(parameters, x.cols(), signals);
  neural::backward(parameters, layers_[0], x, signals.gradients[0].leftCols(x.cols()));
}

void Perceptron::backward(Parameters& parameters, const ConstView& x, Signals& signals, View dx) const {
  backward_to_first(parameters, x.cols(), signals);
  neural::backward(parameters, layers_[0], x, signals.gradients[0].leftCols(x.cols()), dx);
}

}  // namespace waymark::neural
