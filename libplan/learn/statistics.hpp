// Estimates from a few dozen runs, with 95 % confidence intervals.
//
//   rates      Wilson's score interval                                                            [Wil27]
//   others     percentile bootstrap, 2,000 resamples drawn with a fixed seed: the same runs, the same bytes  [ET93, Ch.
//     13]
// Values may be infinite (a goal that was never reached): medians remain meaningful, and may be infinite themselves.
#pragma once
#include <cstddef>
#include <vector>

namespace waymark::plan {

struct Estimate {
  double value = 0, low = 0, high = 0;  // the estimate, and its interval
};

double median(std::vector<double> values);       // the mean of the two in the middle; not empty
double mean(const std::vector<double>& values);  // not empty

// Estimates with their intervals.
Estimate rate(std::size_t successes, std::size_t tries);
Estimate bootstrap_median(const std::vector<double>& values);
Estimate bootstrap_mean(const std::vector<double>& values);

}  // namespace waymark::plan
