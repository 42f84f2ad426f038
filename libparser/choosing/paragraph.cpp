#include "libparser/choosing/paragraph.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace waymark::parser {
namespace {

// A pose that a paragraph may have come to.
struct Standing {
  plan::PoseId pose;
  double probability = 0;  // up to one factor for all
  double best = -1;        // of that, by the likeliest of the ways here
  std::size_t before = 0;  // on it: which of the poses alive one sentence earlier
};

using Next = std::map<plan::PoseId, Standing>;

void add(const Standing& from, std::size_t position, plan::PoseId end, double p, Next& next) {
  Standing& there = next.try_emplace(end, Standing{end}).first->second;
  there.probability += from.probability * p;
  if (from.best * p <= there.best) return;
  there.best = from.best * p;
  there.before = position;
}

// The likeliest first, probabilities made to sum to 1.
std::vector<Standing> likeliest(const Next& all, std::size_t kept) {
  std::vector<Standing> out;
  for (const auto& [pose, standing] : all) out.push_back(standing);
  std::stable_sort(out.begin(), out.end(),
                   [](const Standing& a, const Standing& b) { return a.probability > b.probability; });
  if (out.size() > kept) out.resize(kept);
  double total = 0;
  for (const Standing& standing : out) total += standing.probability;
  for (Standing& standing : out) {
    standing.probability /= total;
    standing.best /= total;
  }
  return out;
}

// Of the likeliest place, the likeliest pose.
std::size_t last_pose(const plan::Map& map, const std::vector<Standing>& alive) {
  std::map<std::uint32_t, double> places;
  for (const Standing& standing : alive) places[map.node_of(standing.pose)] += standing.probability;
  std::size_t best = 0;
  for (std::size_t i = 1; i < alive.size(); ++i)
    if (places[map.node_of(alive[i].pose)] > places[map.node_of(alive[best].pose)]) best = i;
  return best;
}

}  // namespace

std::vector<plan::PoseId> likeliest_way(const plan::Map& map, const Outlook& first, std::size_t sentences,
                                        const std::function<Outlook(std::size_t, plan::PoseId)>& later,
                                        const ParagraphOptions& options) {
  Next next;
  for (const auto& [end, p] : first.ends) add(Standing{end, 1, 1, 0}, 0, end, p, next);
  std::vector<std::vector<Standing>> alive{likeliest(next, options.alive)};
  for (std::size_t k = 1; k < sentences; ++k) {
    const std::vector<Standing>& here = alive.back();
    std::vector<Outlook> outlooks;
    for (const Standing& standing : here) outlooks.push_back(later(k, standing.pose));
    double most = outlooks.front().evidence;
    for (const Outlook& outlook : outlooks) most = std::max(most, outlook.evidence);
    next.clear();
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double weight = std::exp(options.trust_in_locator * (outlooks[i].evidence - most));
      if (outlooks[i].ends.empty()) add(here[i], i, here[i].pose, weight, next);
      for (const auto& [end, p] : outlooks[i].ends) add(here[i], i, end, weight * p, next);
    }
    alive.push_back(likeliest(next, options.alive));
  }
  std::vector<plan::PoseId> way;
  std::size_t i = last_pose(map, alive.back());
  for (std::size_t k = alive.size(); k-- > 0; i = alive[k][i].before) way.push_back(alive[k][i].pose);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace waymark::parser
