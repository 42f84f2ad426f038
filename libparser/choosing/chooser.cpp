#include "libparser/choosing/chooser.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::parser {
namespace {

// Makes scores probabilities; returns the logarithm of what they summed to before.
double normalise(std::vector<double>& scores) {
  const double highest = *std::max_element(scores.begin(), scores.end());
  double total = 0;
  for (double& score : scores) total += score = std::exp(score - highest);
  for (double& score : scores) score /= total;
  return highest + std::log(total);
}

}  // namespace

std::vector<double> scores_of_ends(const LinearModel& model, const WeightTable& table,
                                   const Executor& executor, const SentenceInput& input,
                                   std::span<const plan::PoseId> starts, const Decision& decision) {
  ChooserSentence sentence(model, input);
  for (const End& end : decision.ends)
    sentence.add_end(executor, starts[decision.start[end.candidate]], *decision.plans[end.candidate],
                     end.mass);
  const EndFeatures features = sentence.take();
  const auto weight = [&](std::uint64_t feature) {
    const std::uint32_t row = table.find(feature);
    return row == WeightTable::absent ? 0.0 : static_cast<double>(table.weight(row, 0));
  };
  std::vector<double> bundles;
  for (const auto& bundle : features.bundles) {
    bundles.push_back(0);
    for (std::uint64_t feature : bundle) bundles.back() += weight(feature);
  }
  std::vector<double> scores;
  for (std::size_t i = 0; i < features.ends.size(); ++i) {
    scores.push_back(weight(log_mass_feature()) * static_cast<double>(features.log_mass[i]));
    for (std::uint32_t bundle : features.ends[i]) scores.back() += bundles[bundle];
  }
  return scores;
}

void choose_end(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision) {
  if (model.chooser.rows() == 0 || decision.ends.size() < 2) return;
  std::vector<double> p = scores_of_ends(model, model.chooser, executor, input, starts, decision);
  normalise(p);
  for (std::size_t i = 0; i < p.size(); ++i) decision.ends[i].mass = p[i];
  std::stable_sort(decision.ends.begin(), decision.ends.end(),
                   [](const End& a, const End& b) { return a.mass > b.mass; });
}

double evidence_of_start(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                         plan::PoseId start, const Decision& decision) {
  constexpr double nowhere_to_go = -100;
  if (model.locator.rows() == 0) return 0;
  if (decision.ends.empty()) return nowhere_to_go;
  std::vector<double> scores = scores_of_ends(model, model.locator, executor, input, {&start, 1}, decision);
  return normalise(scores);
}

}  // namespace waymark::parser
