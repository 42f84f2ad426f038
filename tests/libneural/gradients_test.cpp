// Every backward pass against central differences of the loss Σ c ∘ y, with random c.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "libltl/structure/random.hpp"
#include "libneural/perceptron.hpp"
#include "libneural/recursive_encoder.hpp"

namespace waymark::neural {
namespace {

constexpr std::uint64_t seed = 11;

Matrix random_matrix(ltl::Random& random, Index rows, Index columns) {
  Matrix m(rows, columns);
  for (Index i = 0; i < m.size(); ++i) m.data()[i] = static_cast<float>(2 * random.unit() - 1);
  return m;
}

// Differences of the loss on both sides of every entry of `values`, beside the analytic gradient. Networks of ReLUs are
// piecewise linear in each single parameter: where the two sides differ there is a kink within h, and nothing is said.
void check(float* values, const float* gradient, Index count, const std::function<double()>& loss) {
  constexpr float h = 1.0F / 512;
  Index kinks = 0;
  for (Index i = 0; i < count; ++i) {
    const float kept = values[i];
    const double here = loss();
    values[i] = kept + h;
    const double above = (loss() - here) / static_cast<double>(h);
    values[i] = kept - h;
    const double below = (here - loss()) / static_cast<double>(h);
    values[i] = kept;
    const double tolerance = 2e-3 * (1 + std::abs(above));
    if (std::abs(above - below) > tolerance)
      ++kinks;
    else
      EXPECT_NEAR(gradient[i], above, tolerance) << "seed " << seed << ", entry " << i;
  }
  EXPECT_LE(10 * kinks, count) << "seed " << seed;
}

double dot(const Matrix& a, const Matrix& b) { return a.cast<double>().cwiseProduct(b.cast<double>()).sum(); }

TEST(Gradients, OfADenseLayer) {
  ltl::Random random(seed);
  Parameters parameters;
  const Dense layer = add_dense(parameters, 5, 4, [&] { return random.unit(); });
  parameters.value(layer.bias) = random_matrix(random, 4, 1);
  Matrix x = random_matrix(random, 5, 7), y(4, 7), dx(5, 7);
  const Matrix c = random_matrix(random, 4, 7);
  const auto loss = [&] {
    forward(parameters, layer, x, y);
    return dot(c, y);
  };
  backward(parameters, layer, x, c, dx);
  const Vector gradients = parameters.gradients();
  check(parameters.values().data(), gradients.data(), parameters.size(), loss);
  check(x.data(), dx.data(), x.size(), loss);
}

TEST(Gradients, AddUpOverTheUsesOfALayer) {
  ltl::Random random(seed);
  Parameters parameters;
  const Dense layer = add_dense(parameters, 3, 2, [&] { return random.unit(); });
  const Matrix x = random_matrix(random, 3, 4), dy = random_matrix(random, 2, 4);
  backward(parameters, layer, x, dy);
  const Vector once = parameters.gradients();
  backward(parameters, layer, x, dy);
  EXPECT_TRUE(parameters.gradients().isApprox(2 * once));
}

TEST(Gradients, OfAPerceptron) {
  ltl::Random random(seed);
  Parameters parameters;
  const std::array<Index, 4> sizes{6, 9, 8, 3};
  const Perceptron network(parameters, sizes, [&] { return random.unit(); });
  EXPECT_EQ(network.inputs(), 6);
  EXPECT_EQ(network.outputs(), 3);
  Matrix x = random_matrix(random, 6, 10), dx(6, 10);
  const Matrix c = random_matrix(random, 3, 10);
  auto signals = network.signals(10);
  const auto loss = [&] { return dot(c, network.forward(parameters, x, signals)); };
  loss();
  signals.gradients.back() = c;
  network.backward(parameters, x, signals, dx);
  const Vector gradients = parameters.gradients();
  check(parameters.values().data(), gradients.data(), parameters.size(), loss);
  check(x.data(), dx.data(), x.size(), loss);
}

TEST(Gradients, OfARecursiveEncoder) {
  ltl::Random random(seed);
  Parameters parameters;
  const std::array<Index, 4> slots{0, 0, 1, 2};  // two leaves, a sum, an ordered pair
  const RecursiveEncoder encoder(parameters, 12, slots, [&] { return random.unit(); });
  // pair(sum(leaf 0, leaf 1, leaf 0), leaf 1), the inner sum read outside as well
  const std::vector<SymbolNode> nodes{
      {0}, {1}, {2, {{0, 0}, {1, 0}, {0, 0}}}, {3, {{2, 0}, {1, 1}}}, {3, {{1, 0}, {3, 1}}}};
  Matrix h(12, 5), c = Matrix::Zero(12, 5);
  c.col(2) = random_matrix(random, 12, 1);
  c.col(4) = random_matrix(random, 12, 1);
  const auto loss = [&] {
    encoder.forward(parameters, nodes, h);
    return dot(c, h);
  };
  loss();
  Matrix dh = c;
  encoder.backward(parameters, nodes, h, dh);
  const Vector gradients = parameters.gradients();
  EXPECT_GT(gradients.cwiseAbs().maxCoeff(), 0.1F);
  check(parameters.values().data(), gradients.data(), parameters.size(), loss);
}

TEST(Gradients, TheReluPassesNothingWhereItIsZero) {
  Matrix y(1, 3);
  y << -2.0F, 0.0F, 3.0F;
  relu(y);
  EXPECT_EQ(y, (Matrix(1, 3) << 0.0F, 0.0F, 3.0F).finished());
  Matrix dy = Matrix::Ones(1, 3);
  relu_backward(y, dy);
  EXPECT_EQ(dy, (Matrix(1, 3) << 0.0F, 0.0F, 1.0F).finished());
}

}  // namespace
}  // namespace waymark::neural
