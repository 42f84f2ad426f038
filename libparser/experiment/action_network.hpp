// The baseline without formulas: a sentence and what is seen on the way in, actions out, one after the other.
//
//   x = embeddings of the last K actions, and the sum of the embeddings of what holds at the pose
// on the encoder and decoder of encoder_decoder.hpp; the symbols are FORWARD, LEFT, RIGHT and stop. In the spirit of
// [MBW16], which has an LSTM as decoder and looks at the world through two aligners. Learns from gold trajectories by
// likelihood; answers by beam search, and never walks into a wall.
#pragma once
#include <memory>
#include <span>

#include "libparser/experiment/follower.hpp"
#include "libparser/training/learn.hpp"

namespace waymark::parser {

// Learns the baseline that predicts actions without formulas.
std::shared_ptr<const Follower> learn_actions(std::span<const Example* const> examples,
                                              std::span<const Executor> executors, const TrainOptions& options,
                                              const JobProgress& progress);

}  // namespace waymark::parser
