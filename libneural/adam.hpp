// Adam: gradient steps scaled by running means of the gradient and of its square, corrected for their start at zero.
//
//   m ← β₁ m + (1 − β₁) g    v ← β₂ v + (1 − β₂) g²    θ ← θ − rate · (m / (1 − β₁ᵗ)) / (√(v / (1 − β₂ᵗ)) + ε)
// Source: [KB15, Alg. 1]. The two corrections are folded into the rate and ε, as its Section 2 allows.
#pragma once
#include "libneural/parameters.hpp"

namespace waymark::neural {

struct AdamOptions {                                               // the constants of the paper
  double rate = 1e-4, beta1 = 0.9, beta2 = 0.999, epsilon = 1e-8;  // rate, β₁, β₂, ε
};

class Adam {
 public:
  Adam(const Parameters& parameters, const AdamOptions& options = {});
  void set_rate(double rate) { options_.rate = rate; }  // from the next step on
  void step(Parameters& parameters);  // reads the gradients, changes the values, then clears the gradients

 private:
  AdamOptions options_;
  Vector mean_, square_;
  double power1_ = 1, power2_ = 1;  // β₁ᵗ, β₂ᵗ
};

// Gradients longer than that, in the Euclidean norm, are shortened to it. Source: [PMB13, Alg. 1].
void clip_gradients(Parameters& parameters, double longest);

}  // namespace waymark::neural
