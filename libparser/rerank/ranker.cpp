#include "libparser/rerank/ranker.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::parser {

std::vector<double> scores(const WeightTable& weights, const CandidateFeatures& features) {
  std::vector<double> bundles;
  std::size_t near = 0;  // the features of a bundle ascend
  for (const auto& bundle : features.bundles) {
    bundles.push_back(0);
    for (const WeightedFeature& feature : bundle)
      if (const auto row = weights.find(feature.key, near))
        bundles.back() += static_cast<double>(weights.weight(*row, 0)) * static_cast<double>(feature.value);
  }
  std::vector<double> out;
  for (const auto& candidate : features.candidates) {
    out.push_back(0);
    for (const std::uint32_t bundle : candidate) out.back() += bundles[bundle];
  }
  return out;
}

double normalise(std::vector<double>& scores) {
  const double highest = *std::max_element(scores.begin(), scores.end());
  double total = 0;
  for (double& score : scores) total += score = std::exp(score - highest);
  for (double& score : scores) score /= total;
  return highest + std::log(total);
}

}  // namespace waymark::parser
