#include "libplan/solve/discounted_cost.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan {

// The operator Φ brings any two vectors of values nearer by γ, swept in place as well. So a sweep that changes nothing
// by more than δ leaves values within δ γ / (1 − γ) of the fixpoint; rounding adds what it does to one sum, 1 / (1 − γ)
// times.
std::optional<Bounds> discounted_cost(const Mdp& mdp, const DiscountedCosts& asked, double tolerance,
                                      const std::stop_token& stop) {
  constexpr double rounding = 1e-15;  // of a sum, relative to what it is made of
  const double gamma = asked.discount;
  const auto states = static_cast<std::uint32_t>(mdp.states());
  std::vector<double> values(states, 0);
  const auto best = [&](std::uint32_t s) {
    if (!asked.ended.empty() && asked.ended[s]) return 0.0;
    double out = 0;
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      double sum = 0;
      mdp.for_each_outcome(s, k, [&](std::uint32_t t, LetterId, double p) { sum += p * values[t]; });
      const double offered = mdp.cost(s, k) + gamma * sum;
      out = k == 0 ? offered : asked.greatest ? std::max(out, offered) : std::min(out, offered);
    }
    return out;
  };
  for (;;) {
    if (stop.stop_requested()) return std::nullopt;
    double change = 0, most = 0;
    for (std::uint32_t s = 0; s < states; ++s) {
      const double value = best(s);
      change = std::max(change, std::abs(value - values[s]));
      most = std::max(most, std::abs(value));
      values[s] = value;
    }
    const double value = values[mdp.initial()], error = (gamma * change + rounding * most) / (1 - gamma);
    if (change <= rounding * most || 2 * error <= tolerance * std::max(1.0, std::abs(value)))
      return Bounds{std::max(value - error, 0.0), value + error};  // costs are not negative
  }
}

}  // namespace waymark::plan
