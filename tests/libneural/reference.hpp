// The definitions of layers in double precision, one sequence and one number at a time, and gradients of a loss by
// central differences: what the layers in float32 are checked against.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "libltl/structure/random.hpp"
#include "libneural/parameters.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::neural::reference {

using Real = Eigen::MatrixXd;

inline Matrix random_matrix(ltl::Random& random, Index rows, Index columns) {
  Matrix m(rows, columns);
  for (Index i = 0; i < m.size(); ++i) m.data()[i] = static_cast<float>(2 * random.unit() - 1);
  return m;
}

// Takes matrices from the front of an array, in the order in which a layer added them.
class Reader {
 public:
  explicit Reader(const Eigen::VectorXd& values) : values_(values) {}
  Real take(Index rows, Index columns) {
    Real m = Eigen::Map<const Real>(values_.data() + at_, rows, columns);
    at_ += rows * columns;
    return m;
  }

 private:
  const Eigen::VectorXd& values_;
  Index at_ = 0;
};

inline Real sigmoid(const Real& x) { return (1 + (-x.array()).exp()).inverse(); }

// h of every element of one sequence x [inputs × length].
inline Real lstm(Reader& theta, const Real& x, Index width) {
  const Real w = theta.take(4 * width, x.rows()), u = theta.take(4 * width, width), b = theta.take(4 * width, 1);
  Real h = Real::Zero(width, 1), c = h, all(width, x.cols());
  for (Index t = 0; t < x.cols(); ++t) {
    const Real a = w * x.col(t) + u * h + b;
    const Real i = sigmoid(a.topRows(width)), f = sigmoid(a.middleRows(width, width)),
               o = sigmoid(a.middleRows(2 * width, width)), g = a.bottomRows(width).array().tanh();
    c = f.cwiseProduct(c) + i.cwiseProduct(g);
    h = o.array() * c.array().tanh();
    all.col(t) = h;
  }
  return all;
}

// Scores of one choice x of a sequence h with summary e and marks m; φ: a column for each symbol.
inline Real attention(Reader& theta, const Real& phi, Index width, const Real& h, const Real& e, const Real& m,
                      const Real& x) {
  const Index encoded = h.rows();
  const Real from_e = theta.take(width, encoded), from_x = theta.take(width, x.rows()), bias = theta.take(width, 1),
             attend = theta.take(width, encoded), say = theta.take(phi.rows(), width + encoded),
             beta = theta.take(phi.cols(), 1), u = theta.take(width + encoded, 1), u0 = theta.take(1, 1);
  const Real q = (from_e * e + from_x * x + bias).cwiseMax(0);
  Real alpha = (q.transpose() * attend * h).array().exp();
  alpha /= alpha.sum();
  Real both(width + encoded, 1);
  both << q, h * alpha.transpose();
  return phi.transpose() * say * both + beta + m * (u.transpose() * both + u0)(0, 0);
}

// Central differences of `loss` at every entry of `values` beside the gradient that was computed; at every tenth under
// sanitizers.
inline void check(Eigen::VectorXd& values, const float* gradient, const std::function<double()>& loss,
                  const char* what) {
  constexpr double h = 1e-5;
  for (Index i = 0; i < values.size(); i += testing::sanitized ? 10 : 1) {
    const double kept = values[i];
    values[i] = kept + h;
    const double above = loss();
    values[i] = kept - h;
    const double below = loss();
    values[i] = kept;
    const double expected = (above - below) / (2 * h);
    EXPECT_NEAR(gradient[i], expected, 1e-4 * (1 + std::abs(expected))) << what << ", entry " << i;
  }
}

inline double dot(const Matrix& a, const Real& b) { return a.cast<double>().cwiseProduct(b).sum(); }

}  // namespace waymark::neural::reference
