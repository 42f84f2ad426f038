#include "libneural/attention_decoder.hpp"

#include <cassert>

#include "libneural/dense.hpp"

namespace waymark::neural {
namespace {

constexpr float first_gate = 2;  // being named counts from the start

// Softmax of every column, in place.
void normalise(Matrix& scores) {
  for (Index j = 0; j < scores.cols(); ++j) {
    auto column = scores.col(j).array();
    column = (column - column.maxCoeff()).exp();
    column /= column.sum();
  }
}

Index size(std::span<const Index> begin, std::size_t i) { return begin[i + 1] - begin[i]; }

}  // namespace

AttentionDecoder::AttentionDecoder(Parameters& parameters, const Sizes& sizes, const Block& symbols,
                                   const Uniform& uniform)
    : sizes_(sizes), phi_(symbols) {
  assert(symbols.rows == sizes.symbol && symbols.columns >= sizes.symbols);
  phi_.columns = sizes.symbols;
  const Index both = sizes.width + sizes.encoded;
  from_e_ = parameters.add_for_relu(sizes.width, sizes.encoded, sizes.encoded + sizes.inputs, uniform);
  from_x_ = parameters.add_for_relu(sizes.width, sizes.inputs, sizes.encoded + sizes.inputs, uniform);
  bias_ = parameters.add(sizes.width, 1);
  attend_ = parameters.add_for_relu(sizes.width, sizes.encoded, 2 * sizes.encoded, uniform);
  say_ = parameters.add_for_relu(sizes.symbol, both, 2 * both, uniform);
  symbol_bias_ = parameters.add(sizes.symbols, 1);
  gate_ = parameters.add(both, 1);
  gate_bias_ = parameters.add(1, 1);
  parameters.value(gate_bias_).setConstant(first_gate);
}

// What does not depend on what was said.
void AttentionDecoder::attend(const Parameters& parameters, const Sequences& in, Signals& s) const {
  s.from_e.resize(sizes_.width, in.e->cols());
  s.from_e.colwise() = parameters.value(bias_).col(0);
  add_product(parameters.value(from_e_), *in.e, s.from_e);
  s.keys.setZero(sizes_.width, in.h->cols());
  add_product(parameters.value(attend_), *in.h, s.keys);
}

void AttentionDecoder::forward(const Parameters& parameters, const Sequences& in, const ConstView& x,
                               Signals& s) const {
  const Index n = in.begin.back(), w = sizes_.width;
  assert(x.rows() == sizes_.inputs && static_cast<Index>(in.said.size()) == n && in.h_begin.back() == in.h->cols());
  s.from_x.setZero(w, x.cols());
  add_product(parameters.value(from_x_), x, s.from_x);
  if (!in.is_attended) attend(parameters, in, s);
  s.q_and_c.resize(w + sizes_.encoded, n);
  auto q = s.q_and_c.topRows(w);
  for (std::size_t i = 0; i + 1 < in.begin.size(); ++i)
    for (Index j = in.begin[i]; j < in.begin[i + 1]; ++j)
      q.col(j) =
          (s.from_e.col(static_cast<Index>(i)) + s.from_x.col(in.said[static_cast<std::size_t>(j)])).cwiseMax(0.0F);
  s.weights.resize(in.begin.size() - 1);
  s.q_and_c.bottomRows(sizes_.encoded).setZero();
  for (std::size_t i = 0; i + 1 < in.begin.size(); ++i) {
    const Index at = in.begin[i], m = size(in.begin, i), from = in.h_begin[i], length = size(in.h_begin, i);
    s.weights[i].setZero(length, m);
    add_transposed_product(s.keys.middleCols(from, length), q.middleCols(at, m), s.weights[i]);
    normalise(s.weights[i]);
    add_product(in.h->middleCols(from, length), s.weights[i], s.q_and_c.bottomRows(sizes_.encoded).middleCols(at, m));
  }
  s.y.setZero(sizes_.symbol, n);
  add_product(parameters.value(say_), s.q_and_c, s.y);
  s.scores.resize(sizes_.symbols, n);
  s.scores.colwise() = parameters.value(symbol_bias_).col(0);
  add_transposed_product(parameters.value(phi_), s.y, s.scores);
  if (in.marks == nullptr) return;
  s.gate.noalias() = parameters.value(gate_).transpose() * s.q_and_c;
  s.gate.array() += parameters.value(gate_bias_)(0);
  for (std::size_t i = 0; i + 1 < in.begin.size(); ++i)
    s.scores.middleCols(in.begin[i], size(in.begin, i)).noalias() +=
        in.marks->col(static_cast<Index>(i)) * s.gate.middleCols(in.begin[i], size(in.begin, i));
}

void AttentionDecoder::backward(Parameters& parameters, const Sequences& in, const ConstView& x, Signals& s,
                                View dx) const {
  const Parameters& constant = parameters;
  const Index n = in.begin.back(), w = sizes_.width, encoded = sizes_.encoded;
  assert(s.dscores.cols() == n && s.dscores.rows() == sizes_.symbols);
  s.dq_and_c.setZero(w + encoded, n);
  if (in.marks != nullptr) {
    Matrix dgate(1, n);
    for (std::size_t i = 0; i + 1 < in.begin.size(); ++i)
      dgate.middleCols(in.begin[i], size(in.begin, i)).noalias() =
          in.marks->col(static_cast<Index>(i)).transpose() * s.dscores.middleCols(in.begin[i], size(in.begin, i));
    parameters.gradient(gate_).noalias() += s.q_and_c * dgate.transpose();
    parameters.gradient(gate_bias_)(0) += dgate.sum();
    s.dq_and_c.noalias() += constant.value(gate_) * dgate;
  }
  parameters.gradient(symbol_bias_).col(0) += s.dscores.rowwise().sum();
  add_product_transposed(s.y, s.dscores, parameters.gradient(phi_));
  s.dy.setZero(sizes_.symbol, n);
  add_product(constant.value(phi_), s.dscores, s.dy);
  add_product_transposed(s.dy, s.q_and_c, parameters.gradient(say_));
  add_transposed_product(constant.value(say_), s.dy, s.dq_and_c);
  auto dq = s.dq_and_c.topRows(w), dc = s.dq_and_c.bottomRows(encoded);
  const auto q = s.q_and_c.topRows(w);
  s.dh.setZero(encoded, in.h->cols());
  s.dkeys.setZero(w, in.h->cols());
  Matrix dweights;
  for (std::size_t i = 0; i + 1 < in.begin.size(); ++i) {
    const Index at = in.begin[i], m = size(in.begin, i), from = in.h_begin[i], length = size(in.h_begin, i);
    const Matrix& weights = s.weights[i];
    add_product_transposed(dc.middleCols(at, m), weights, s.dh.middleCols(from, length));
    dweights.setZero(length, m);
    add_transposed_product(in.h->middleCols(from, length), dc.middleCols(at, m), dweights);
    for (Index j = 0; j < m; ++j) {
      const float mean = weights.col(j).dot(dweights.col(j));
      dweights.col(j).array() = weights.col(j).array() * (dweights.col(j).array() - mean);
    }
    add_product_transposed(q.middleCols(at, m), dweights, s.dkeys.middleCols(from, length));
    add_product(s.keys.middleCols(from, length), dweights, dq.middleCols(at, m));
  }
  relu_backward(q, dq);
  add_product_transposed(s.dkeys, *in.h, parameters.gradient(attend_));
  add_transposed_product(constant.value(attend_), s.dkeys, s.dh);
  Matrix dsaid(w, in.e->cols());
  for (std::size_t i = 0; i + 1 < in.begin.size(); ++i)
    dsaid.col(static_cast<Index>(i)) = dq.middleCols(in.begin[i], size(in.begin, i)).rowwise().sum();
  parameters.gradient(bias_).col(0) += dsaid.rowwise().sum();
  add_product_transposed(dsaid, *in.e, parameters.gradient(from_e_));
  s.de.setZero(encoded, in.e->cols());
  add_transposed_product(constant.value(from_e_), dsaid, s.de);
  s.from_x.setZero();  // ∂ from here on
  for (Index j = 0; j < n; ++j) s.from_x.col(in.said[static_cast<std::size_t>(j)]) += dq.col(j);
  add_product_transposed(s.from_x, x, parameters.gradient(from_x_));
  dx.setZero();
  add_transposed_product(constant.value(from_x_), s.from_x, dx);
}

}  // namespace waymark::neural
