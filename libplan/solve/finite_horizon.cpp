#include "libplan/solve/finite_horizon.hpp"

#include <algorithm>
#include <vector>

namespace waymark::plan {

std::optional<double> expected_cost(const Mdp& mdp, const Horizon& horizon, const std::stop_token& stop) {
  const auto states = static_cast<std::uint32_t>(mdp.states());
  std::vector<double> now(states, 0), later(states, 0);  // by state, with so many steps to go
  const auto best = [&](std::uint32_t s, const auto& value) {
    double out = 0;
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      const double v = value(k);
      out = k == 0 ? v : horizon.greatest ? std::max(out, v) : std::min(out, v);
    }
    return out;
  };
  if (horizon.instantaneous)
    for (std::uint32_t s = 0; s < states; ++s) now[s] = best(s, [&](std::uint32_t k) { return mdp.cost(s, k); });
  for (std::uint64_t step = 0; step < horizon.steps; ++step) {
    if (stop.stop_requested()) return std::nullopt;
    later.swap(now);
    for (std::uint32_t s = 0; s < states; ++s)
      now[s] = best(s, [&](std::uint32_t k) {
        double sum = horizon.instantaneous ? 0 : mdp.cost(s, k);
        mdp.for_each_outcome(s, k,
                             [&](std::uint32_t t, LetterId, double p) { sum += p * horizon.discount * later[t]; });
        return sum;
      });
  }
  return now[mdp.initial()];
}

}  // namespace waymark::plan
