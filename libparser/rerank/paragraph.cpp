#include "libparser/rerank/paragraph.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace waymark::parser {
namespace {

// A pose that a paragraph may have come to.
struct Hypothesis {
  plan::PoseId pose;
  double probability = 0;  // up to one factor for all
  double best = -1;        // of that, by the likeliest of the ways here
  std::size_t before = 0;  // on it: which of the poses hypotheses one sentence earlier
};

using Next = std::map<plan::PoseId, Hypothesis>;

void add(const Hypothesis& from, std::size_t position, plan::PoseId end, double p, Next& next) {
  Hypothesis& there = next.try_emplace(end, Hypothesis{end}).first->second;
  there.probability += from.probability * p;
  if (from.best * p <= there.best) return;
  there.best = from.best * p;
  there.before = position;
}

// The likeliest first, probabilities made to sum to 1.
std::vector<Hypothesis> likeliest(const Next& all, std::size_t kept) {
  std::vector<Hypothesis> out;
  for (const auto& [pose, hypothesis] : all) out.push_back(hypothesis);
  std::stable_sort(out.begin(), out.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.probability > b.probability; });
  if (out.size() > kept) out.resize(kept);
  double total = 0;
  for (const Hypothesis& hypothesis : out) total += hypothesis.probability;
  for (Hypothesis& hypothesis : out) {
    hypothesis.probability /= total;
    hypothesis.best /= total;
  }
  return out;
}

// Of the likeliest place, the likeliest pose.
std::size_t last_pose(const plan::Map& map, const std::vector<Hypothesis>& hypotheses) {
  std::map<std::uint32_t, double> places;
  for (const Hypothesis& hypothesis : hypotheses) places[map.node_of(hypothesis.pose)] += hypothesis.probability;
  std::size_t best = 0;
  for (std::size_t i = 1; i < hypotheses.size(); ++i)
    if (places[map.node_of(hypotheses[i].pose)] > places[map.node_of(hypotheses[best].pose)]) best = i;
  return best;
}

}  // namespace

std::vector<plan::PoseId> likeliest_way(const plan::Map& map, const TransitionDistribution& first,
                                        std::size_t sentences,
                                        const std::function<TransitionDistribution(std::size_t, plan::PoseId)>& later,
                                        const ParagraphOptions& options) {
  Next next;
  for (const auto& [end, p] : first.ends) add(Hypothesis{end, 1, 1, 0}, 0, end, p, next);
  std::vector<std::vector<Hypothesis>> hypotheses{likeliest(next, options.beam_width)};
  for (std::size_t k = 1; k < sentences; ++k) {
    const std::vector<Hypothesis>& here = hypotheses.back();
    std::vector<TransitionDistribution> outlooks;
    for (const Hypothesis& hypothesis : here) outlooks.push_back(later(k, hypothesis.pose));
    double most = outlooks.front().evidence;
    for (const TransitionDistribution& outlook : outlooks) most = std::max(most, outlook.evidence);
    next.clear();
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double weight = std::exp(options.trust_in_start_pose * (outlooks[i].evidence - most));
      if (outlooks[i].ends.empty()) add(here[i], i, here[i].pose, weight, next);
      for (const auto& [end, p] : outlooks[i].ends) add(here[i], i, end, weight * p, next);
    }
    hypotheses.push_back(likeliest(next, options.beam_width));
  }
  std::vector<plan::PoseId> way;
  std::size_t i = last_pose(map, hypotheses.back());
  for (std::size_t k = hypotheses.size(); k-- > 0; i = hypotheses[k][i].before) way.push_back(hypotheses[k][i].pose);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace waymark::parser
