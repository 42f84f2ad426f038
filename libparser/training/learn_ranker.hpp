// Learning the ranker: one step of AdaGrad [DHS11] up log p(a right candidate) for each decision, in an order drawn
// anew in each epoch.
//
// One wrong candidate may be known to be the likeliest mistake, the rival. It is pushed away once more:
//   loss = −log p(right) + against_rival · log(1 + exp(1 + score(rival) − score(right)))
// A row of weights is stepped for each decision that has its feature, by the sum of the gradients of all candidates.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "libparser/domain/domain.hpp"
#include "libparser/rerank/ranker.hpp"
#include "libparser/supervision/examples.hpp"
#include "libparser/training/parallel.hpp"

namespace waymark::parser {

struct RankerOptions {              // how a ranker is trained
  std::uint64_t seed = 1;           // the order of the decisions
  int epochs = 6;                   // over all decisions
  double rate = 0.03, decay = 0.2;  // AdaGrad's learning rate and L2, for every step of a row
  double first_squares = 1e-6;      // what AdaGrad's sums of squared gradients begin with
  double least_error = 0;           // a bundle whose error is smaller teaches nothing
  double against_rival = 0;         // 0: the rival is a candidate like any other
  // Steps a row once more, by its decay alone, whenever its gradient stands at zero and a further candidate has its
  // feature.
  bool decay_again = false;
  std::size_t least_maps = 1;  // features met on fewer maps are left out: they are about those maps
  std::stop_token stop = {};   // polled once for each decision; then Stopped is thrown
};

// A decision whose right candidates are known, its features as rows of the table that is learned.
struct LabelledDecision {
  struct Row {      // a feature of the table
    WeightRow row;  // of the feature
    float value;    // of the feature
  };
  std::size_t map = 0;                                 // on which the decision was made
  std::vector<std::vector<Row>> bundles;               // features that candidates share
  std::vector<std::vector<std::uint32_t>> candidates;  // by bundles
  std::vector<std::size_t> right;                      // at least one
  std::optional<std::size_t> rival;                    // of the first right candidate
};

// The decision without its labels, its features numbered by the table, which gets a row for each new one.
LabelledDecision numbered(const CandidateFeatures& features, WeightTable& weights);

// Goes on from the weights that the table has. Leaves features of fewer than `least_maps` maps out of the decisions.
void learn_ranker(WeightTable& weights, std::span<LabelledDecision> decisions, const RankerOptions& options,
                  const JobProgress& progress);

// Learns from all texts that have a right candidate and a wrong one. O(features) memory for each text.
template <Domain D>
void learn_ranker(D& domain, std::span<const typename D::Text> texts, WeightTable& weights,
                  const RankerOptions& options, const JobProgress& progress) {
  std::vector<LabelledDecision> decisions;
  for (const typename D::Text& text : texts) {
    if (options.stop.stop_requested()) throw Stopped{};
    const typename D::Candidates& candidates = domain.candidates(text);
    std::vector<std::size_t> right;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (D::right(text, D::execute(candidates[i]))) right.push_back(i);
    if (right.empty() || right.size() == candidates.size()) continue;
    LabelledDecision& decision = decisions.emplace_back(numbered(domain.features(text, candidates), weights));
    decision.map = D::map_of(text);
    if constexpr (DomainWithRivals<D>) decision.rival = D::rival(candidates, right.front());
    decision.right = std::move(right);
  }
  learn_ranker(weights, decisions, options, progress);
}

}  // namespace waymark::parser
