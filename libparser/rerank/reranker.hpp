// The reranker: which of the ends that candidate programs lead to is meant, judged by the routes there.
//
//   p(end | sentence, start) ∝ exp(a · log mass(end) + w · f(sentence, route from start to end))
// The reader knows words and programs, the reranker also sees what a route does and passes: route_features.hpp. Trained
// on the same trajectories as the reader, on candidates of readers that had not seen the map: learn_reranker.hpp.
//
// The start-pose model has features and weights of the same kind and is asked the other way round, at which of several
// poses the sentence is said:
//   p(start | sentence) ∝ Σ_end exp(a' · log mass(end) + w' · f(sentence, route from start to end))
// Along a paragraph it is what later sentences tell about where earlier ones ended: paragraph.hpp.
#pragma once
#include <span>
#include <vector>

#include "libparser/rerank/route_features.hpp"

namespace waymark::parser {

// The ends of a decision are sorted by the reranker's probability, `mass` replaced by it.
// Does nothing when the model has no reranker.
void choose_end(const RankingModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision);

// The same, and log p(start | sentence) up to one constant for each sentence: 0 when the model has no start-pose model;
// less than any other when the decision has no ends.
double choose_and_locate(const RankingModel& model, const Executor& executor, const SentenceInput& input,
                         plan::PoseId start, Decision& decision);

}  // namespace waymark::parser
