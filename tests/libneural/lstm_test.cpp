#include "libneural/lstm.hpp"

#include <array>

#include "tests/libneural/reference.hpp"

namespace waymark::neural {
namespace {

using reference::Reader;
using reference::Real;

constexpr std::array<Index, 4> lengths{5, 3, 3, 1};

// The entries of one sequence, from packed columns and back.
Real sequence_of(const Packing& packing, const Eigen::Ref<const Real>& x, Index s) {
  Real out(x.rows(), packing.length(s));
  for (Index t = 0; t < packing.length(s); ++t) out.col(t) = x.col(packing.column(s, t));
  return out;
}

TEST(Packing, PutsTheStepsOneAfterTheOther) {
  const Packing packing(lengths);
  EXPECT_EQ(packing.columns(), 12);
  EXPECT_EQ(packing.steps(), 5);
  std::array<bool, 12> seen{};
  for (Index s = 0; s < packing.sequences(); ++s)
    for (Index t = 0; t < packing.length(s); ++t) {
      bool& here = seen[static_cast<std::size_t>(packing.column(s, t))];
      EXPECT_FALSE(here);
      here = true;
      EXPECT_LT(s, packing.running(t));
    }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](bool b) { return b; }));
}

TEST(Lstm, IsTheDefinitionAndItsGradient) {
  ltl::Random random(5);
  Parameters parameters;
  const Lstm layer(parameters, 3, 4, [&] { return random.unit(); });
  const Packing packing(lengths);
  const Matrix x = reference::random_matrix(random, 3, packing.columns()),
               c = reference::random_matrix(random, 4, packing.columns());
  Lstm::Signals signals;
  layer.forward(parameters, packing, x, signals);
  Eigen::VectorXd theta = parameters.values().cast<double>(), inputs = x.reshaped().cast<double>();
  const auto expected = [&] {
    Real h(4, packing.columns());
    const Eigen::Map<const Real> in(inputs.data(), 3, packing.columns());
    for (Index s = 0; s < packing.sequences(); ++s) {
      Reader reader(theta);
      const Real own = reference::lstm(reader, sequence_of(packing, in, s), 4);
      for (Index t = 0; t < own.cols(); ++t) h.col(packing.column(s, t)) = own.col(t);
    }
    return h;
  };
  EXPECT_LT((signals.h.cast<double>() - expected()).cwiseAbs().maxCoeff(), 1e-5);
  Matrix dx(3, packing.columns());
  signals.dh = c;
  layer.backward(parameters, packing, x, signals, dx);
  const auto loss = [&] { return reference::dot(c, expected()); };
  reference::check(theta, parameters.gradients().data(), loss, "parameters");
  reference::check(inputs, dx.data(), loss, "inputs");
}

TEST(BidirectionalLstm, IsTwoOfThemAndItsGradient) {
  ltl::Random random(6);
  Parameters parameters;
  const BidirectionalLstm layer(parameters, 3, 2, [&] { return random.unit(); });
  const Packing packing(lengths);
  const Matrix x = reference::random_matrix(random, 3, packing.columns()),
               c = reference::random_matrix(random, 4, packing.columns()),
               d = reference::random_matrix(random, 4, packing.sequences());
  Eigen::VectorXd theta = parameters.values().cast<double>(), inputs = x.reshaped().cast<double>();
  struct Outputs {
    Real h, last;
  };
  const auto expected = [&] {
    Outputs out{Real(4, packing.columns()), Real(4, packing.sequences())};
    const Eigen::Map<const Real> in(inputs.data(), 3, packing.columns());
    for (Index s = 0; s < packing.sequences(); ++s) {
      Reader reader(theta);
      const Real own = sequence_of(packing, in, s);
      const Real there = reference::lstm(reader, own, 2);
      const Real back = reference::lstm(reader, own.rowwise().reverse(), 2);
      for (Index t = 0; t < own.cols(); ++t)
        out.h.col(packing.column(s, t)) << there.col(t), back.col(own.cols() - 1 - t);
      out.last.col(s) << there.rightCols(1), back.rightCols(1);
    }
    return out;
  };
  BidirectionalLstm::Signals signals;
  layer.forward(parameters, packing, x, signals);
  EXPECT_LT((signals.h.cast<double>() - expected().h).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_LT((signals.last.cast<double>() - expected().last).cwiseAbs().maxCoeff(), 1e-5);
  Matrix dx(3, packing.columns());
  signals.dh = c;
  signals.dlast = d;
  layer.backward(parameters, packing, x, signals, dx);
  const auto loss = [&] {
    const Outputs out = expected();
    return reference::dot(c, out.h) + reference::dot(d, out.last);
  };
  reference::check(theta, parameters.gradients().data(), loss, "parameters");
  reference::check(inputs, dx.data(), loss, "inputs");
}

}  // namespace
}  // namespace waymark::neural
