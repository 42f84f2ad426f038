#include "libneural/lstm.hpp"

#include <cassert>

namespace waymark::neural {
namespace {

auto sigmoid(const auto& x) { return (1.0F + (-x).exp()).inverse(); }

// ∂gates before their σ and tanh, and ∂cell of the step before, from ∂h and ∂cell of this one. Columns [at, at + n).
void step_back(Lstm::Signals& s, Index width, Index at, Index n, Index before) {
  auto gates = s.gates.middleCols(at, n).array();
  auto i = gates.topRows(width), f = gates.middleRows(width, width), o = gates.middleRows(2 * width, width),
       g = gates.bottomRows(width);
  const auto tanh_cell = s.tanh_cell.middleCols(at, n).array();
  const auto dh = s.dh.middleCols(at, n).array();
  auto dcell = s.dcell.middleCols(at, n).array();
  dcell += dh * o * (1.0F - tanh_cell.square());
  o = dh * tanh_cell * o * (1.0F - o);
  const Matrix di = dcell * g * i * (1.0F - i);
  if (before >= 0) {
    s.dcell.middleCols(before, n).array() = dcell * f;
    f = dcell * s.cell.middleCols(before, n).array() * f * (1.0F - f);
  } else {
    f.setZero();
  }
  g = dcell * i * (1.0F - g.square());
  i = di.array();
}

// Columns of packed sequences, each sequence from its end.
void reverse(const Packing& packing, const ConstView& x, Matrix& reversed) {
  reversed.resize(x.rows(), x.cols());
  for (Index s = 0; s < packing.sequences(); ++s)
    for (Index t = 0; t < packing.length(s); ++t)
      reversed.col(packing.column(s, t)) = x.col(packing.column(s, packing.length(s) - 1 - t));
}

}  // namespace

Lstm::Lstm(Parameters& parameters, Index inputs, Index width, const Uniform& uniform) {
  // Uniform in ±√(3 / inputs): gates keep a variance of one through σ and tanh, half of what ReLU layers need.
  input_ = parameters.add_for_relu(4 * width, inputs, 2 * inputs, uniform);
  recurrent_ = parameters.add_for_relu(4 * width, width, 2 * width, uniform);
  bias_ = parameters.add(4 * width, 1);
  parameters.value(bias_).middleRows(width, width).setOnes();
}

void Lstm::forward(const Parameters& parameters, const Packing& packing, const ConstView& x, Signals& s) const {
  assert(x.cols() == packing.columns() && x.rows() == inputs());
  const Index n = packing.columns(), w = width();
  s.gates.resize(4 * w, n);
  for (Matrix* m : {&s.cell, &s.tanh_cell, &s.h}) m->resize(w, n);
  s.gates.colwise() = parameters.value(bias_).col(0);
  add_product(parameters.value(input_), x, s.gates);
  for (Index t = 0; t < packing.steps(); ++t) {
    const Index at = packing.begin(t), m = packing.running(t);
    if (t > 0)
      add_product(parameters.value(recurrent_), s.h.middleCols(packing.begin(t - 1), m), s.gates.middleCols(at, m));
    auto gates = s.gates.middleCols(at, m).array();
    gates.topRows(3 * w) = sigmoid(gates.topRows(3 * w));
    gates.bottomRows(w) = gates.bottomRows(w).tanh();
    auto cell = s.cell.middleCols(at, m).array();
    cell = gates.topRows(w) * gates.bottomRows(w);
    if (t > 0) cell += gates.middleRows(w, w) * s.cell.middleCols(packing.begin(t - 1), m).array();
    s.tanh_cell.middleCols(at, m).array() = cell.tanh();
    s.h.middleCols(at, m).array() = gates.middleRows(2 * w, w) * s.tanh_cell.middleCols(at, m).array();
  }
}

void Lstm::backward(Parameters& parameters, const Packing& packing, const ConstView& x, Signals& s, View dx) const {
  assert(s.dh.cols() == packing.columns() && s.dh.rows() == width());
  const Parameters& constant = parameters;
  s.dcell.setZero(width(), packing.columns());
  for (Index t = packing.steps() - 1; t >= 0; --t) {
    const Index at = packing.begin(t), m = packing.running(t), before = t > 0 ? packing.begin(t - 1) : -1;
    step_back(s, width(), at, m, before);
    if (t == 0) break;
    const auto dgates = s.gates.middleCols(at, m);
    add_product_transposed(dgates, s.h.middleCols(before, m), parameters.gradient(recurrent_));
    add_transposed_product(constant.value(recurrent_), dgates, s.dh.middleCols(before, m));
  }
  add_product_transposed(s.gates, x, parameters.gradient(input_));
  parameters.gradient(bias_).col(0) += s.gates.rowwise().sum();
  dx.setZero();
  add_transposed_product(constant.value(input_), s.gates, dx);
}

BidirectionalLstm::BidirectionalLstm(Parameters& parameters, Index inputs, Index width, const Uniform& uniform)
    : forwards_(parameters, inputs, width, uniform), backwards_(parameters, inputs, width, uniform) {}

void BidirectionalLstm::forward(const Parameters& parameters, const Packing& packing, const ConstView& x,
                                Signals& s) const {
  const Index w = forwards_.width();
  reverse(packing, x, s.reversed);
  forwards_.forward(parameters, packing, x, s.forwards);
  backwards_.forward(parameters, packing, s.reversed, s.backwards);
  s.h.resize(2 * w, packing.columns());
  s.h.topRows(w) = s.forwards.h;
  s.last.resize(2 * w, packing.sequences());
  for (Index i = 0; i < packing.sequences(); ++i) {
    const Index end = packing.length(i) - 1;
    for (Index t = 0; t <= end; ++t)
      s.h.col(packing.column(i, t)).bottomRows(w) = s.backwards.h.col(packing.column(i, end - t));
    s.last.col(i).topRows(w) = s.forwards.h.col(packing.column(i, end));
    s.last.col(i).bottomRows(w) = s.backwards.h.col(packing.column(i, end));
  }
}

void BidirectionalLstm::backward(Parameters& parameters, const Packing& packing, const ConstView& x, Signals& s,
                                 View dx) const {
  const Index w = forwards_.width();
  assert(s.dh.rows() == 2 * w && s.dlast.cols() == packing.sequences());
  s.forwards.dh = s.dh.topRows(w);
  s.backwards.dh.resize(w, packing.columns());
  for (Index i = 0; i < packing.sequences(); ++i) {
    const Index end = packing.length(i) - 1;
    for (Index t = 0; t <= end; ++t)
      s.backwards.dh.col(packing.column(i, end - t)) = s.dh.col(packing.column(i, t)).bottomRows(w);
    s.forwards.dh.col(packing.column(i, end)) += s.dlast.col(i).topRows(w);
    s.backwards.dh.col(packing.column(i, end)) += s.dlast.col(i).bottomRows(w);
  }
  s.dreversed.resize(x.rows(), x.cols());
  backwards_.backward(parameters, packing, s.reversed, s.backwards, s.dreversed);
  forwards_.backward(parameters, packing, x, s.forwards, dx);
  Matrix again;
  reverse(packing, s.dreversed, again);
  dx += again;
}

}  // namespace waymark::neural
