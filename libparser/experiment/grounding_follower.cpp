#include "libparser/experiment/grounding_follower.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "libparser/choosing/chooser.hpp"

namespace waymark::parser {
namespace {

// Where a paragraph may have come to, and by which way most likely.
struct Standing {
  plan::PoseId pose;
  double probability = 0;   // up to one factor for all
  double likeliest = 0;     // of that, by the likeliest of the ways here
  std::size_t before = 0;   // on it: which of the poses alive one sentence earlier
  Answer answer = {};       // on it: to this sentence
};

// The poses after one more sentence; probabilities are those of `from` times the verdict's, which has none where it stays.
void add_ends(const std::vector<Standing>& alive, std::size_t from, double weight,
              const GroundingFollower::Verdict& verdict, std::map<plan::PoseId, Standing>& next) {
  const auto add = [&](const Answer& answer, double p) {
    Standing& there = next.try_emplace(answer.end, Standing{answer.end, 0, -1, 0, {}}).first->second;
    there.probability += p * alive[from].probability;
    if (p * alive[from].likeliest <= there.likeliest) return;
    there.likeliest = p * alive[from].likeliest;
    there.before = from;
    there.answer = answer;
  };
  if (verdict.answers.empty()) add({alive[from].pose, {}, {}, 0}, weight);
  for (const Answer& answer : verdict.answers) add(answer, weight * answer.probability);
}

// The likeliest first, probabilities made to sum to 1.
std::vector<Standing> likeliest(std::map<plan::PoseId, Standing> all, std::size_t kept) {
  std::vector<Standing> out;
  for (auto& [pose, standing] : all) out.push_back(std::move(standing));
  std::stable_sort(out.begin(), out.end(),
                   [](const Standing& a, const Standing& b) { return a.probability > b.probability; });
  if (out.size() > kept) out.resize(kept);
  double total = 0;
  for (const Standing& standing : out) total += standing.probability;
  for (Standing& standing : out) {
    standing.probability /= total;
    standing.likeliest /= total;
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

GroundingFollower::Readings GroundingFollower::read(const SentenceInput& input) const {
  Readings readings;
  for (const Grounder& grounder : grounders_)
    readings.push_back(likely_programs(grounder, input, how_.deciding));
  return readings;
}

GroundingFollower::Verdict GroundingFollower::judge(const Executor& executor, const SentenceInput& input,
                                                    const Readings& readings, plan::PoseId start) const {
  Verdict verdict;
  std::vector<double> most;  // by answer: what a grounder gave it
  const auto members = static_cast<double>(grounders_.size());
  for (std::size_t g = 0; g < grounders_.size(); ++g) {
    const LinearModel& model = *grounders_[g].model;
    Decision decision = decide(readings[g], executor, {&start, 1}, how_.deciding.then);
    if (how_.alive > 1)
      verdict.evidence += evidence_of_start(model, executor, input, start, decision) / members;
    choose_end(model, executor, input, {&start, 1}, decision);
    double total = 0;
    for (const End& end : decision.ends) total += end.mass;
    for (const End& end : decision.ends) {
      const auto found = std::find_if(verdict.answers.begin(), verdict.answers.end(),
                                      [&](const Answer& a) { return a.end == end.pose; });
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
  for (const Answer& answer : verdict.answers) total += answer.probability;
  for (Answer& answer : verdict.answers) answer.probability /= total;
  std::stable_sort(verdict.answers.begin(), verdict.answers.end(),
                   [](const Answer& a, const Answer& b) { return a.probability > b.probability; });
  return verdict;
}

Answer GroundingFollower::follow(const Executor& executor, const SentenceInput& input,
                                 plan::PoseId start) const {
  Verdict verdict = judge(executor, input, read(input), start);
  if (verdict.answers.empty()) return {start, {}, {}, 0};
  return std::move(verdict.answers.front());
}

std::vector<Answer> GroundingFollower::follow_all(const Executor& executor,
                                                  std::span<const SentenceInput> paragraph,
                                                  plan::PoseId start) const {
  if (how_.alive <= 1) return Follower::follow_all(executor, paragraph, start);
  std::vector<std::vector<Standing>> alive{{Standing{start, 1, 1, 0, {}}}};
  for (SentenceInput input : paragraph) {
    const std::vector<Standing>& here = alive.back();
    input.heading_unknown = input.heading_unknown && alive.size() == 1;
    const Readings readings = read(input);
    std::vector<Verdict> verdicts;
    for (const Standing& standing : here)
      verdicts.push_back(judge(executor, input, readings, standing.pose));
    double most = verdicts.front().evidence;
    for (const Verdict& verdict : verdicts) most = std::max(most, verdict.evidence);
    std::map<plan::PoseId, Standing> next;
    for (std::size_t i = 0; i < here.size(); ++i)
      add_ends(here, i, std::exp(how_.trust_in_locator * (verdicts[i].evidence - most)), verdicts[i], next);
    alive.push_back(likeliest(std::move(next), how_.alive));
  }
  std::vector<Answer> answers;
  std::size_t i = last_pose(executor.map(), alive.back());
  for (std::size_t k = alive.size(); --k > 0; i = alive[k][i].before)
    answers.push_back(std::move(alive[k][i].answer));
  std::reverse(answers.begin(), answers.end());
  return answers;
}

}  // namespace waymark::parser
