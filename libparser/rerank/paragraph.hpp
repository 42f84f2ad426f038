// The reading of a paragraph as a whole: a beam of poses is kept, and later sentences tell which of them was meant.
//
//   P_k(end) = Σ_start P_{k−1}(start) · e^(trust · evidence_k(start)) · p_k(end | start)
// Only the `beam_width` likeliest poses are kept. p_k(end | start) is the reranker's, the evidence the start-pose
// model's (reranker.hpp). The reranker's probabilities sum to 1 from every start, so they cannot express that a
// sentence makes no sense there; the start-pose model can. The result ends at the place that is likeliest after the
// last sentence, and is the likeliest sequence of poses that leads there. With beam width 1, each sentence is decided
// before the next one is read.
#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "libplan/world/map.hpp"

namespace waymark::parser {

struct ParagraphOptions {
  std::size_t beam_width = 12;       // poses; at least 1
  double trust_in_start_pose = 0.5;  // its weight beside the reranker's probabilities
};

// What a sentence comes to from one start: ends, probabilities that sum to 1, the most probable first; none: it stays.
struct TransitionDistribution {
  std::vector<std::pair<plan::PoseId, double>> ends;  // likeliest first
  double evidence = 0;                                // log p(start | sentence) up to one constant for each sentence
};

// The poses of the result after each sentence. first: the distribution after sentence 0, not empty. later(k, start):
// the one after sentence k, 1 ≤ k < sentences, asked at most `beam_width` times for each k.
// O(sentences · beam_width · ends · log).
std::vector<plan::PoseId> likeliest_way(const plan::Map& map, const TransitionDistribution& first,
                                        std::size_t sentences,
                                        const std::function<TransitionDistribution(std::size_t, plan::PoseId)>& later,
                                        const ParagraphOptions& options);

}  // namespace waymark::parser
