#include "libparser/experiment/follower.hpp"

#include <algorithm>

#include "libparser/choosing/chooser.hpp"

namespace waymark::parser {
namespace {

struct Vote {
  plan::PoseId end;
  double sum = 0, most = 0;
  Answer answer;  // of whoever gives it the most
};

}  // namespace

Answer GroundingFollower::follow(const Executor& executor, const SentenceInput& input,
                                 plan::PoseId start) const {
  std::vector<Vote> votes;
  for (const Grounder& grounder : grounders_) {
    Decision decision = decide(grounder, executor, input, {&start, 1}, how_);
    choose_end(*grounder.model, executor, input, {&start, 1}, decision);
    double total = 0;
    for (const End& end : decision.ends) total += end.mass;
    for (const End& end : decision.ends) {
      auto vote = std::find_if(votes.begin(), votes.end(), [&](const Vote& v) { return v.end == end.pose; });
      if (vote == votes.end()) vote = votes.insert(vote, Vote{end.pose, 0, 0, {}});
      const double share = end.mass / total;
      vote->sum += share;
      if (share <= vote->most) continue;
      vote->most = share;
      vote->answer = {end.pose, decision.plans[end.candidate]->actions,
                      decision.candidates[end.candidate].program, 0};
    }
  }
  const auto best = std::max_element(votes.begin(), votes.end(),
                                     [](const Vote& a, const Vote& b) { return a.sum < b.sum; });
  if (best == votes.end()) return {start, {}, {}, 0};
  best->answer.probability = best->sum / static_cast<double>(grounders_.size());
  return best->answer;
}

}  // namespace waymark::parser
