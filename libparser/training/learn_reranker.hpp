// Learning of the reranker and the start-pose model: the ranker in the domain of hallways, once for each question.
//
//   ends     candidates: the ends of a sentence's programs from its gold start; right: the gold end
//   starts   candidates: the ends from the gold start and from a few poses where the sentence before could have ended
//            instead; right: those that begin at the gold start
// The programs come from a reader that has not learned from the sentence (learn.cpp leaves out the map). Otherwise the
// reranker would learn to trust probabilities that are too high. The only supervision is whether the end pose of a
// candidate is right.
#pragma once
#include <span>
#include <vector>

#include "libparser/domain/hallways/hallways.hpp"
#include "libparser/rerank/reranker.hpp"
#include "libparser/training/learn.hpp"

namespace waymark::parser {

struct RankingInstances {
  std::vector<RankingInstance> of_ends, of_starts;  // for each question
  void add(RankingInstances&& more);                // behind what is there
};

// Examples in the order of their paragraphs; the instances point at them. Added to what is there.
void add_ranking_instances(const Grounder& reader, std::span<const Example* const> examples,
                           std::span<const Executor> executors, const TrainOptions& options,
                           RankingInstances& instances);

// The same reader with a reranker and a start-pose model learned for it.
Grounder with_reranker(const Grounder& reader, const RankingInstances& instances, std::span<const Executor> executors,
                       const TrainOptions& options, const JobProgress& progress);

}  // namespace waymark::parser
