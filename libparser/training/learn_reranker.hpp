// Learning the reranker and the start-pose model: the ranker in the domain of hallways, once for each question.
//
//   of ends     the candidates are the ends of a sentence's programs from its gold start; right is the gold end
//   of starts   the candidates are the ends from the gold start and from a few poses where the sentence before could have ended
//               instead; right is whatever begins at the gold start
// The programs must come from a reader that has not learned from the sentence (learn.cpp leaves out the whole map), or
// the reranker would learn to trust probabilities that are too good. The end pose of a candidate is right or wrong:
// that is all the supervision there is.
#pragma once
#include <span>
#include <vector>

#include "libparser/domain/hallways/hallways.hpp"
#include "libparser/rerank/reranker.hpp"
#include "libparser/training/learn.hpp"

namespace waymark::parser {

struct RankingInstances {
  std::vector<RankingInstance> of_ends, of_starts;
  void add(RankingInstances&& more);
};

// Examples in the order of their paragraphs; the instances point at them. Added to what is there.
void add_ranking_instances(const Grounder& reader, std::span<const Example* const> examples,
                           std::span<const Executor> executors, const TrainOptions& options,
                           RankingInstances& instances);

// The same reader with a reranker and a start-pose model learned for it.
Grounder with_reranker(const Grounder& reader, const RankingInstances& instances,
                       std::span<const Executor> executors, const TrainOptions& options,
                       const JobProgress& progress);

}  // namespace waymark::parser
