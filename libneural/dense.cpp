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
  add_product(parameters.value(layer.weight), x, y);
}

void backward(Parameters& parameters, const Dense& layer, const ConstView& x, const ConstView& dy) {
  assert(x.rows() == layer.weight.columns && dy.rows() == layer.weight.rows && x.cols() == dy.cols());
  add_product_transposed(dy, x, parameters.gradient(layer.weight));
  parameters.gradient(layer.bias).col(0) += dy.rowwise().sum();
}

void backward(Parameters& parameters, const Dense& layer, const ConstView& x, const ConstView& dy, View dx) {
  assert(dx.rows() == x.rows() && dx.cols() == x.cols());
  backward(parameters, layer, x, dy);
  const Parameters& constant = parameters;
  dx.setZero();
  add_transposed_product(constant.value(layer.weight), dy, dx);
}

void relu(View y) { y = y.cwiseMax(0.0F); }

void relu_backward(const ConstView& y, View dy) {
  for (Index j = 0; j < dy.cols(); ++j) {  // plain loops: compilers turn them into masks, Eigen's select stays scalar
    const float* kept = y.data() + j * y.outerStride();
    float* gradient = dy.data() + j * dy.outerStride();
    for (Index i = 0; i < dy.rows(); ++i) gradient[i] = kept[i] > 0.0F ? gradient[i] : 0.0F;
  }
}

}  // namespace waymark::neural
