#include "libparser/rerank/decide.hpp"

#include <algorithm>
#include <cmath>

#include "libparser/decode/clauses.hpp"
#include "libparser/lexicon/lexicon.hpp"
#include "libparser/supervision/lexical_overlap.hpp"

namespace waymark::parser {

std::vector<Weighed> likely_programs(const Grounder& grounder, const SentenceInput& input, const Deciding& how) {
  const Wording wording(grounder.ranking->language, mentions(input.tokens));
  std::vector<Weighed> weighed;
  const auto read_one = [&](const SentenceInput& one, std::size_t beam) {
    return read(grounder.word_model, one, beam);
  };
  for (Candidate& candidate : how.clauses ? read_by_clauses(read_one, input, how.beam) : read_one(input, how.beam)) {
    const double lexical_overlap_penalty = how.trust * wording.lexical_overlap_penalty(candidate.program),
                 p = candidate.log_probability;
    weighed.push_back({std::move(candidate.program), p - trust_in_wording * lexical_overlap_penalty,
                       p - trust_at_one_end * lexical_overlap_penalty});
  }
  std::stable_sort(weighed.begin(), weighed.end(),
                   [](const Weighed& a, const Weighed& b) { return a.log_weight > b.log_weight; });
  return weighed;
}

std::optional<std::pair<Plan, std::size_t>> plan_from(const Executor& executor, const Program& program,
                                                      std::span<const plan::PoseId> starts, Then then) {
  std::optional<std::pair<Plan, std::size_t>> best;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    auto plan = executor.run(program, starts[i], then);
    if (plan && (!best || plan->actions.size() < best->first.actions.size())) best.emplace(std::move(*plan), i);
  }
  return best;
}

std::vector<End> rank_ends(std::span<const Weighed> candidates, std::span<const std::optional<Plan>> plans) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!plans[i]) continue;
    const plan::PoseId pose = plans[i]->end;
    auto end = std::find_if(ends.begin(), ends.end(), [&](const End& e) { return e.pose == pose; });
    if (end == ends.end()) end = ends.insert(end, End{pose, 0, i});
    end->mass += std::exp(candidates[i].log_weight);
    if (candidates[i].preference > candidates[end->candidate].preference) end->candidate = i;
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.mass > b.mass; });
  return ends;
}

Decision decide(std::vector<Weighed> candidates, const Executor& executor, std::span<const plan::PoseId> starts,
                Then then) {
  Decision decision;
  decision.candidates = std::move(candidates);
  for (const Weighed& candidate : decision.candidates) {
    auto plan = plan_from(executor, candidate.program, starts, then);
    decision.start.push_back(plan ? plan->second : 0);
    decision.plans.push_back(plan ? std::optional<Plan>(std::move(plan->first)) : std::nullopt);
  }
  decision.ends = rank_ends(decision.candidates, decision.plans);
  return decision;
}

Decision decide(const Grounder& grounder, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, const Deciding& how) {
  return decide(likely_programs(grounder, input, how), executor, starts, how.then);
}

}  // namespace waymark::parser
