// Learning the encoder-decoder from trajectories: sentences and gold routes in, a reader out.
//
// The programs that may be rewarded are those the search finds to be consistent (search.hpp) and, from time to time,
// those of the network's own beam; or those of its randomised beam alone, as in the paper. What a program is rewarded
// by is the feedback, r(z) in [0, 1]; the objectives, of p = p(z | sentence):
//   mml          log Σ p r                    gradient p r / Σ p r
//   reinforce    Σ p r                        gradient p r
//   meritocratic                              gradient (p r)^β / Σ (p r)^β, between mml (β = 1) and all alike (β = 0)
// Source: [GPLL17, Sec. 3.2 and 4.2]. Sums run over the programs found. Adam, gradients clipped by their norm. A batch
// falls into a fixed number of shards whose gradients are added in order: the same bytes at any number of threads.
#pragma once
#include <memory>

#include "libparser/model/word_model.hpp"
#include "libparser/training/learn.hpp"

namespace waymark::parser {

// As learn_reader of learn.hpp.
std::shared_ptr<const NetworkModel> learn_network(std::span<const Example* const> examples,
                                                  std::span<const Executor> executors, const TrainOptions& options,
                                                  const JobProgress& progress);

}  // namespace waymark::parser
