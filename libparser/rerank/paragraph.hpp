// A paragraph as a whole: several poses are kept beam_width, and what is said next tells which of them was meant.
//
//   P_k(end) = Σ_start P_{k−1}(start) · e^(trust · evidence_k(start)) · p_k(end | start),   the `beam_width` likeliest kept
// with p_k(end | start) the reranker's and the evidence the start-pose model's (reranker.hpp): probabilities that sum to 1 from every start
// cannot say that a sentence makes no sense there, the start-pose model does. The way taken ends at the place that is likeliest after the
// last sentence, and is the likeliest single way to the likeliest pose there. With one pose beam_width each sentence is settled
// before the next is heard.
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
  std::vector<std::pair<plan::PoseId, double>> ends;
  double evidence = 0;  // log p(start | sentence) up to one constant for each sentence
};

// Where the way taken stands after each sentence. first: the outlook of sentence 0, which may not be empty; later(k, start): of
// sentence k ≥ 1 < sentences, asked at most `beam_width` times for each k. O(sentences · beam_width · ends · log).
std::vector<plan::PoseId> likeliest_way(
    const plan::Map& map, const TransitionDistribution& first, std::size_t sentences,
    const std::function<TransitionDistribution(std::size_t, plan::PoseId)>& later,
    const ParagraphOptions& options);

}  // namespace waymark::parser
