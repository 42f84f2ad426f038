#include "libparser/rerank/reranker.hpp"

#include <algorithm>

namespace waymark::parser {
namespace {

CandidateFeatures features_of(const RankingModel& model, const Executor& executor, const SentenceInput& input,
                              std::span<const plan::PoseId> starts, const Decision& decision) {
  RerankerSentence sentence(model, input);
  for (const End& end : decision.ends)
    sentence.add_end(executor, starts[decision.start[end.candidate]], *decision.plans[end.candidate], end.mass);
  return sentence.take();
}

void choose(const RankingModel& model, const CandidateFeatures& features, Decision& decision) {
  std::vector<double> p = scores(model.reranker, features);
  normalise(p);
  for (std::size_t i = 0; i < p.size(); ++i) decision.ends[i].mass = p[i];
  std::stable_sort(decision.ends.begin(), decision.ends.end(),
                   [](const End& a, const End& b) { return a.mass > b.mass; });
}

bool chooses(const RankingModel& model, const Decision& decision) {
  return model.reranker.rows() > 0 && decision.ends.size() > 1;
}

}  // namespace

void choose_end(const RankingModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision) {
  if (chooses(model, decision)) choose(model, features_of(model, executor, input, starts, decision), decision);
}

double choose_and_locate(const RankingModel& model, const Executor& executor, const SentenceInput& input,
                         plan::PoseId start, Decision& decision) {
  constexpr double nowhere_to_go = -100;
  const bool locates = model.start_pose_model.rows() > 0;
  if (decision.ends.empty()) return locates ? nowhere_to_go : 0;
  if (!locates && !chooses(model, decision)) return 0;
  const CandidateFeatures features = features_of(model, executor, input, {&start, 1}, decision);
  double evidence = 0;
  if (locates) {
    std::vector<double> located = scores(model.start_pose_model, features);
    evidence = normalise(located);
  }
  if (chooses(model, decision)) choose(model, features, decision);
  return evidence;
}

}  // namespace waymark::parser
