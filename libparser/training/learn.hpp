// Weakly supervised learning: sentences and trajectories in, a reader and a reranker out. No formula is ever given.
//
// For each sentence the consistent programs are searched for (search.hpp): those whose plan from the gold start pose
// ends at the gold end pose. The model maximises their marginal likelihood, Σ_z p(z | sentence), by Adagrad; after the
// first epochs the model's own beam adds longer consistent programs. Source: the objective of [GPLL17, Eq. 4]; the
// planner as feedback is (c) of docs/results.md.
// Same seed, same machine, same bytes, at any number of threads.
#pragma once
#include <cstdint>
#include <span>
#include <stop_token>

#include "libparser/corpus/corpus.hpp"
#include "libparser/decode/grounder.hpp"
#include "libparser/model/network_options.hpp"
#include "libparser/supervision/examples.hpp"
#include "libparser/training/parallel.hpp"

namespace waymark::parser {

enum class ReaderKind : std::uint8_t { Linear, EncoderDecoder };

struct TrainOptions {                            // how a model is trained
  ReaderKind reader = ReaderKind::Linear;        // which word model
  Dialect dialect = Dialect::Plain;              // of the programs
  NetworkTraining network = {};                  // of the encoder-decoder
  std::uint64_t seed = 1;                        // of all randomness
  int epochs = 6;                                // of the linear model
  int threads = 2;                               // no influence on the result
  Convention convention = Convention::Absolute;  // of unknown headings
  Then then = Then::WholePlan;                   // the meaning of `then` while training and deciding
  double learning_rate = 0.03;                   // Adagrad
  double decay = 1e-2;                           // L2, per update of a row
  double mention = 4.0;                          // first weight of naming what the sentence mentions
  double other_route = 0.3;                      // weight of a consistent program whose route is not the gold one
  double wording = 2.0;         // … by e^−wording per unit of lexical-overlap penalty (lexical_overlap.hpp)
  int explore_from = 2;         // from this epoch on, every second one searches the own beam for consistent programs
  std::size_t explore = 32;     // how many programs of it
  bool mirrored = true;         // every sentence also as its mirror image
  bool reranker = true;         // also learn to choose between ends on the map
  int reranker_epochs = 6;      // over all decisions
  double reranker_rate = 0.03;  // AdaGrad
  double reranker_decay = 0.2;  // L2
  std::size_t beam = 64;        // programs a sentence
  double trust = 1;             // in wording when deciding: 0 takes the reader's word for everything
  bool clauses = true;          // when deciding, sentences of several are also read clause by clause
  std::size_t beam_width = 12;  // poses kept along a paragraph; 1: each sentence is settled before the next is heard
  // Called from the calling thread, fraction in [0, 1], never decreasing.
  Report progress = {};
  std::stop_token stop = {};  // polled once per sentence; then Stopped (examples.hpp) is thrown
};

// Every map that a paragraph names must be among `maps`, and all of them must share one vocabulary
// (std::invalid_argument otherwise). Sentences without a trajectory are left out.
Grounder train(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options = {});

// The same from examples whose programs were found: several models can share one search.
Grounder train_on(std::span<const Example* const> examples, std::span<const Executor> executors,
                  const TrainOptions& options);

// Without a reranker: ends are chosen by probability alone.
Grounder learn_reader(std::span<const Example* const> examples, std::span<const Executor> executors,
                      const TrainOptions& options, const JobProgress& progress);

}  // namespace waymark::parser
