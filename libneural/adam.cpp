#include "libneural/adam.hpp"

#include <cassert>
#include <cmath>

namespace waymark::neural {

Adam::Adam(const Parameters& parameters, const AdamOptions& options)
    : options_(options), mean_(Vector::Zero(parameters.size())), square_(Vector::Zero(parameters.size())) {}

void Adam::step(Parameters& parameters) {
  assert(parameters.size() == mean_.size());
  power1_ *= options_.beta1;
  power2_ *= options_.beta2;
  const double scale = std::sqrt(1 - power2_);
  const auto rate = static_cast<float>(options_.rate * scale / (1 - power1_));
  const auto epsilon = static_cast<float>(options_.epsilon * scale);
  const auto beta1 = static_cast<float>(options_.beta1), beta2 = static_cast<float>(options_.beta2);
  auto theta = parameters.values().array();
  auto g = parameters.gradients().array();
  auto m = mean_.array();
  auto v = square_.array();
  m = beta1 * m + (1.0F - beta1) * g;
  v = beta2 * v + (1.0F - beta2) * g.square();
  theta -= rate * m / (v.sqrt() + epsilon);
  g = 0.0F;
}

void clip_gradients(Parameters& parameters, double longest) {
  const double norm = parameters.gradients().cast<double>().norm();
  if (norm > longest) parameters.gradients() *= static_cast<float>(longest / norm);
}

}  // namespace waymark::neural
