#include "libparser/decide.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::parser {

std::optional<std::pair<Plan, std::size_t>> plan_from(const Executor& executor, const Program& program,
                                                      std::span<const plan::PoseId> starts, Then then) {
  std::optional<std::pair<Plan, std::size_t>> best;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    auto plan = executor.run(program, starts[i], then);
    if (plan && (!best || plan->actions.size() < best->first.actions.size()))
      best.emplace(std::move(*plan), i);
  }
  return best;
}

std::vector<End> rank_ends(std::span<const double> probabilities,
                           std::span<const std::optional<Plan>> plans) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!plans[i]) continue;
    const plan::PoseId pose = plans[i]->end;
    auto end = std::find_if(ends.begin(), ends.end(), [&](const End& e) { return e.pose == pose; });
    if (end == ends.end()) end = ends.insert(end, End{pose, 0, i});
    end->mass += probabilities[i];
    if (probabilities[i] > probabilities[end->candidate]) end->candidate = i;
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.mass > b.mass; });
  return ends;
}

Decision decide(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, std::size_t beam, Then then) {
  const SentenceFeatures features = sentence_features(input, model.words);
  Scorer scorer(model, features);
  Decision decision;
  decision.candidates = best_programs(scorer, model.grammar(), beam);
  std::vector<double> probabilities;
  for (const Candidate& candidate : decision.candidates) {
    auto plan = plan_from(executor, candidate.program, starts, then);
    decision.start.push_back(plan ? plan->second : 0);
    decision.plans.push_back(plan ? std::optional<Plan>(std::move(plan->first)) : std::nullopt);
    probabilities.push_back(std::exp(candidate.log_probability));
  }
  decision.ends = rank_ends(probabilities, decision.plans);
  return decision;
}

}  // namespace waymark::parser
