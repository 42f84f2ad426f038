// A dense layer and the ReLU, each as a pair: forward, and backward from the gradient of the output.
//
//   x [inputs × batch]    y [outputs × batch]    W [outputs × inputs]    b [outputs × 1]
//   forward    y = W x + b
//   backward   ∂W += ∂y xᵀ     ∂b += Σ over the batch of ∂y     ∂x = Wᵀ ∂y
// Gradients of parameters are added, so several uses of one layer sum up; ∂x is overwritten. Matrices must already have
// their shapes (asserted): nothing is allocated here.
#pragma once
#include "libneural/multiply.hpp"

namespace waymark::neural {

struct Dense {
  Block weight, bias;  // W, b
};

// Adds the parameters of a layer, W as for a ReLU and b zero.
Dense add_dense(Parameters& parameters, Index inputs, Index outputs, const Uniform& uniform);

// y = W x + b.
void forward(const Parameters& parameters, const Dense& layer, const ConstView& x, View y);
void backward(Parameters& parameters, const Dense& layer, const ConstView& x, const ConstView& dy);  // no ∂x
void backward(Parameters& parameters, const Dense& layer, const ConstView& x, const ConstView& dy, View dx);

// y = max(0, y), in place.
void relu(View y);
// ∂ before the ReLU, in place of ∂ behind it: zero where y, the output of the ReLU, is zero.
void relu_backward(const ConstView& y, View dy);

}  // namespace waymark::neural
