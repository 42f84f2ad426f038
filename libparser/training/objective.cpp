#include "libparser/training/objective.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::parser {

std::vector<float> objective_gradient(Objective objective, double beta, std::span<const float> log_p,
                                      std::span<const float> log_r) {
  std::vector<float> g(log_p.size());
  if (g.empty()) return g;
  for (std::size_t z = 0; z < g.size(); ++z) g[z] = log_p[z] + log_r[z];
  if (objective == Objective::Reinforce) {
    for (float& x : g) x = std::exp(x);
    return g;
  }
  const auto power = static_cast<float>(objective == Objective::Meritocratic ? beta : 1.0);
  const float highest = *std::max_element(g.begin(), g.end());
  float total = 0;
  for (float& x : g) total += x = std::exp(power * (x - highest));
  for (float& x : g) x /= total;
  return g;
}

}  // namespace waymark::parser
