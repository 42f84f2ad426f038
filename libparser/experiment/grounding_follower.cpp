#include "libparser/experiment/grounding_follower.hpp"

#include <algorithm>

#include "libparser/rerank/reranker.hpp"

namespace waymark::parser {
GroundingFollower::Readings GroundingFollower::read(const SentenceInput& input) const {
  Readings readings;
  for (const Grounder& grounder : grounders_) readings.push_back(likely_programs(grounder, input, how_.deciding));
  return readings;
}

GroundingFollower::Verdict GroundingFollower::judge(const Executor& executor, const SentenceInput& input,
                                                    const Readings& readings, plan::PoseId start) const {
  Verdict verdict;
  std::vector<double> most;  // by answer: what a grounder gave it
  const auto members = static_cast<double>(grounders_.size());
  for (std::size_t g = 0; g < grounders_.size(); ++g) {
    const RankingModel& model = *grounders_[g].ranking;
    Decision decision = decide(readings[g], executor, {&start, 1}, how_.deciding.then);
    verdict.evidence += choose_and_locate(model, executor, input, start, decision) / members;
    double total = 0;
    for (const End& end : decision.ends) total += end.mass;
    for (const End& end : decision.ends) {
      const auto found = std::find_if(verdict.answers.begin(), verdict.answers.end(),
                                      [&](const Response& a) { return a.end == end.pose; });
      const auto i = static_cast<std::size_t>(found - verdict.answers.begin());
      if (found == verdict.answers.end()) {
        verdict.answers.push_back({end.pose, {}, {}, 0});
        most.push_back(0);
      }
      const double share = end.mass / total;
      verdict.answers[i].probability += share;
      if (share <= most[i]) continue;
      most[i] = share;
      verdict.answers[i].actions = decision.plans[end.candidate]->actions;
      verdict.answers[i].program = decision.candidates[end.candidate].program;
    }
  }
  double total = 0;  // a grounder that finds no end has no vote
  for (const Response& answer : verdict.answers) total += answer.probability;
  for (Response& answer : verdict.answers) answer.probability /= total;
  std::stable_sort(verdict.answers.begin(), verdict.answers.end(),
                   [](const Response& a, const Response& b) { return a.probability > b.probability; });
  return verdict;
}

Response GroundingFollower::follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const {
  Verdict verdict = judge(executor, input, read(input), start);
  if (verdict.answers.empty()) return {start, {}, {}, 0};
  return std::move(verdict.answers.front());
}

std::vector<Response> GroundingFollower::follow_all(const Executor& executor, std::span<const SentenceInput> paragraph,
                                                    plan::PoseId start) const {
  if (how_.paragraph.beam_width <= 1 || paragraph.empty()) return Follower::follow_all(executor, paragraph, start);
  std::vector<SentenceInput> inputs(paragraph.begin(), paragraph.end());
  std::vector<Readings> readings;
  for (SentenceInput& input : inputs) {
    input.heading_unknown = input.heading_unknown && readings.empty();
    readings.push_back(read(input));
  }
  const auto judged = [&](std::size_t k, plan::PoseId from) { return judge(executor, inputs[k], readings[k], from); };
  const auto outlook = [&](std::size_t k, plan::PoseId from) {
    const Verdict verdict = judged(k, from);
    TransitionDistribution out{{}, verdict.evidence};
    for (const Response& answer : verdict.answers) out.ends.emplace_back(answer.end, answer.probability);
    return out;
  };
  TransitionDistribution first = outlook(0, start);
  if (first.ends.empty()) first.ends.emplace_back(start, 1);
  std::vector<Response> answers;
  for (const plan::PoseId end : likeliest_way(executor.map(), first, inputs.size(), outlook, how_.paragraph)) {
    Response answer{start, {}, {}, 0};
    for (Response& one : judged(answers.size(), start).answers)
      if (one.end == end) answer = std::move(one);
    answers.push_back(std::move(answer));
    start = end;
  }
  return answers;
}

}  // namespace waymark::parser
