// Objectives of training over the programs z found for a sentence, with probabilities p_z and rewards times priors r_z.
//
//   REINFORCE              Σ p_z r_z
//   marginal likelihood    log Σ p_z r_z
//   meritocratic, β        (1/β) log Σ (p_z r_z)^β: β = 1 is marginal likelihood; β → 0 treats all programs alike
// Source: [GPLL17], where the three are compared.
#pragma once
#include <span>
#include <vector>

#include "libparser/model/network_options.hpp"

namespace waymark::parser {

// ∂ objective / ∂ log p_z, by program; β is read of Meritocratic alone.
std::vector<float> objective_gradient(Objective objective, double beta, std::span<const float> log_p,
                                      std::span<const float> log_r);

}  // namespace waymark::parser
