#include "libneural/recursive_encoder.hpp"

#include <cassert>

namespace waymark::neural {

RecursiveEncoder::RecursiveEncoder(Parameters& parameters, Index width, std::span<const Index> slots,
                                   const Uniform& uniform) {
  // Biases are drawn as well: they are all that tells one leaf from another.
  bias_ = parameters.add_for_relu(width, static_cast<Index>(slots.size()), width, uniform);
  for (const Index count : slots) {
    first_.push_back(weights_.size());
    for (Index slot = 0; slot < count; ++slot)
      weights_.push_back(parameters.add_for_relu(width, width, width, uniform));
  }
}

void RecursiveEncoder::forward(const Parameters& parameters, std::span<const SymbolNode> nodes, Matrix& h) const {
  assert(h.rows() == width() && h.cols() == static_cast<Index>(nodes.size()));
  for (Index v = 0; v < h.cols(); ++v) {
    const SymbolNode& node = nodes[static_cast<std::size_t>(v)];
    h.col(v) = parameters.value(bias_).col(node.symbol);
    for (const SymbolNode::Child& child : node.children)
      h.col(v).noalias() += parameters.value(weight(node.symbol, child.slot)) * h.col(child.node);
    h.col(v) = h.col(v).cwiseMax(0.0F);
  }
}

void RecursiveEncoder::backward(Parameters& parameters, std::span<const SymbolNode> nodes, const Matrix& h,
                                Matrix& dh) const {
  assert(dh.rows() == h.rows() && dh.cols() == h.cols());
  const Parameters& constant = parameters;
  for (Index v = h.cols() - 1; v >= 0; --v) {
    const SymbolNode& node = nodes[static_cast<std::size_t>(v)];
    dh.col(v).array() = (h.col(v).array() > 0.0F).select(dh.col(v).array(), 0.0F);
    parameters.gradient(bias_).col(node.symbol) += dh.col(v);
    for (const SymbolNode::Child& child : node.children) {
      const Block& w = weight(node.symbol, child.slot);
      parameters.gradient(w).noalias() += dh.col(v) * h.col(child.node).transpose();
      dh.col(child.node).noalias() += constant.value(w).transpose() * dh.col(v);
    }
  }
}

}  // namespace waymark::neural
