#include "libplan/learn/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libltl/structure/random.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t resamples = 2'000;
constexpr std::uint64_t resampling_seed = 1;
constexpr double two_sided_95 = 1.959963984540054;  // Φ⁻¹(0.975)

template <class Statistic>
Estimate bootstrap(const std::vector<double>& values, Statistic&& statistic) {
  ltl::Random random(resampling_seed);
  std::vector<double> drawn(values.size()), results;
  for (std::size_t i = 0; i < resamples; ++i) {
    for (double& value : drawn) value = values[random.below(values.size())];
    results.push_back(statistic(drawn));
  }
  std::sort(results.begin(), results.end());
  const auto tail = static_cast<std::size_t>(0.025 * resamples);
  return {statistic(values), results[tail], results[resamples - 1 - tail]};
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1 || values[middle - 1] == values[middle]) return values[middle];
  return (values[middle - 1] + values[middle]) / 2;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Estimate rate(std::size_t successes, std::size_t tries) {
  const double n = static_cast<double>(tries), p = static_cast<double>(successes) / n;
  const double z2 = two_sided_95 * two_sided_95;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = two_sided_95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return {p, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Estimate bootstrap_median(const std::vector<double>& values) {
  return bootstrap(values, [](const std::vector<double>& drawn) { return median(drawn); });
}
Estimate bootstrap_mean(const std::vector<double>& values) {
  return bootstrap(values, [](const std::vector<double>& drawn) { return mean(drawn); });
}

}  // namespace waymark::plan
