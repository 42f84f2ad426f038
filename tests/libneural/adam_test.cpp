#include "libneural/adam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libltl/structure/random.hpp"

namespace waymark::neural {
namespace {

// The update as [KB15, Alg. 1] writes it, in double, one number at a time.
struct ByDefinition {
  double theta, m = 0, v = 0;
  int t = 0;
  void step(double g, const AdamOptions& o) {
    ++t;
    m = o.beta1 * m + (1 - o.beta1) * g;
    v = o.beta2 * v + (1 - o.beta2) * g * g;
    const double corrected_m = m / (1 - std::pow(o.beta1, t)), corrected_v = v / (1 - std::pow(o.beta2, t));
    theta -= o.rate * corrected_m / (std::sqrt(corrected_v) + o.epsilon);
  }
};

TEST(Adam, IsTheDefinition) {
  ltl::Random random(3);
  Parameters parameters;
  const Block block = parameters.add(2, 3);
  const AdamOptions options{.rate = 0.01};
  Adam adam(parameters, options);
  std::vector<ByDefinition> expected(6, {0.0});
  for (int t = 0; t < 200; ++t) {
    for (Index i = 0; i < 6; ++i) {
      const double g = (2 * random.unit() - 1) * std::pow(10.0, static_cast<double>(i) - 3);
      parameters.gradients()[i] = static_cast<float>(g);
      expected[static_cast<std::size_t>(i)].step(static_cast<float>(g), options);
    }
    adam.step(parameters);
    EXPECT_EQ(parameters.gradients().cwiseAbs().maxCoeff(), 0.0F);
  }
  for (Index i = 0; i < 6; ++i)
    EXPECT_NEAR(parameters.value(block)(i % 2, i / 2), expected[static_cast<std::size_t>(i)].theta, 1e-4);
}

TEST(ClipGradients, ShortensWhatIsTooLongAndTurnsNothing) {
  ltl::Random random(4);
  for (const double longest : {0.5, 5.0, 50.0}) {
    Parameters parameters;
    parameters.add(4, 5);
    for (Index i = 0; i < 20; ++i) parameters.gradients()[i] = static_cast<float>(6 * random.unit() - 3);
    const Eigen::VectorXd before = parameters.gradients().cast<double>();
    clip_gradients(parameters, longest);
    const double share = std::min(1.0, longest / before.norm());
    EXPECT_LT((parameters.gradients().cast<double>() - share * before).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_EQ(share < 1, longest < 10);
  }
}

TEST(Adam, FindsTheMinimumOfABadlyScaledQuadratic) {
  Parameters parameters;
  parameters.add(2, 1);
  Adam adam(parameters, {.rate = 0.02});
  for (int t = 0; t < 3000; ++t) {
    parameters.gradients()[0] = 100 * (parameters.values()[0] - 1);
    parameters.gradients()[1] = 0.01F * (parameters.values()[1] + 2);
    adam.step(parameters);
  }
  EXPECT_NEAR(parameters.values()[0], 1, 1e-3);
  EXPECT_NEAR(parameters.values()[1], -2, 1e-3);
}

}  // namespace
}  // namespace waymark::neural
