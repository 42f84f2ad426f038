// The ranker: which of several candidates is meant, a softmax over weighted sparse features.
//
//   p(candidate) ∝ exp(w · f(candidate))
// It knows nothing of what candidates are: ends of hallway routes and of start poses (reranker.hpp), routes over
// streets (domain/streets). The weights are one column of a WeightTable; training/learn_ranker.hpp learns them.
#pragma once
#include <cstdint>
#include <vector>

#include "libparser/model/weight_table.hpp"

namespace waymark::parser {

struct WeightedFeature {
  std::uint64_t key;  // a number of the feature
  float value;        // of the feature
};

// Features of all candidates of one decision. Features that several candidates share are listed and weighted once, as a
// bundle.
struct CandidateFeatures {
  std::vector<std::vector<WeightedFeature>> bundles;   // features that candidates share
  std::vector<std::vector<std::uint32_t>> candidates;  // bundles of each; one may count twice
};

// w · f of every candidate: logarithms, up to one constant for each decision. A feature without a row weighs 0.
std::vector<double> scores(const WeightTable& weights, const CandidateFeatures& features);

// Turns scores into probabilities; returns the logarithm of what their exponentials sum to. Requires one score or more.
double normalise(std::vector<double>& scores);

}  // namespace waymark::parser
