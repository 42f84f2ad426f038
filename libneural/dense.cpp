#include "libneural/dense.hpp"

#include <cassert>

namespace waymark::neural {

Dense add_dense(Parameters& parameters, Index inputs, Index outputs, const Uniform& uniform) {
  const Block weight = parameters.add_for_relu(outputs, inputs, inputs, uniform);
  const Block bias = parameters.add(outputs, 1);
  return {weight, bias};
}

void forward(const Parameters& parameters, const Dense& layer, const ConstView& x, View y) {
  assert(x.rows() == layer.weight.columns && y.rows() == layer.weight.rows && x.cols() == y.cols());
  y.colwise() = parameters.value(layer.bias).col(0);
  y.noalias() += parameters.value(layer.weight) * x;
}

void backward(Parameters& parameters, const Dense& layer, const ConstView& x, const ConstView& dy) {
  assert(x.rows() == layer.weight.columns && dy.rows() == layer.weight.rows && x.cols() == dy.cols());
  parameters.gradient(layer.weight).noalias() += dy * x.transpose();
  parameters.gradient(layer.bias).col(0) += dy.rowwise().sum();
}

void backward(Parameters& parameters, const Dense& layer, const ConstView& x, const ConstView& dy, View dx) {
  assert(dx.rows() == x.rows() && dx.cols() == x.cols());
  backward(parameters, layer, x, dy);
  const Parameters& constant = parameters;
  dx.noalias() = constant.value(layer.weight).transpose() * dy;
}

void relu(View y) { y = y.cwiseMax(0.0F); }

void relu_backward(const ConstView& y, View dy) { dy.array() = (y.array() > 0.0F).select(dy.array(), 0.0F); }

}  // namespace waymark::neural
