// The sizes of an encoder-decoder and the parameters of its training.
#pragma once
#include <cstddef>
#include <cstdint>

namespace waymark::parser {

struct NetworkOptions {
  std::int32_t word = 48;    // size of the embeddings of words
  std::int32_t width = 64;   // of each of the two LSTMs
  std::int32_t query = 64;   // of q
  std::int32_t symbol = 32;  // of the embeddings of symbols, φ
  std::int32_t history = 4;  // K: symbols that a choice looks back on
  bool lexicon = true;       // what a sentence mentions is marked
  friend bool operator==(const NetworkOptions&, const NetworkOptions&) = default;
};

enum class Objective : std::uint8_t { MarginalLikelihood, Reinforce, Meritocratic };  // of training
enum class FeedbackKind : std::uint8_t {                                              // what a program earns
  Plan,           // the plan of φ ends where the gold trajectory ends
  Progression,    // the gold trajectory satisfies φ
  Discriminating  // … and neither a strict prefix of it nor another trajectory from the same start does
};
enum class ProgramSearch : std::uint8_t {  // where programs come from
  Consistent,                              // what search.hpp finds, and some of the own beam
  Beam                                     // the own randomised beam alone
};

struct NetworkTraining {                                // how a network is trained
  NetworkOptions sizes = {};                            // of the layers
  int epochs = 4;                                       // over all sentences
  std::size_t batch = 16;                               // sentences
  double rate = 3e-3;                                   // Adam, falling linearly to nothing
  double dropout = 0.25, word_dropout = 0.05;           // shares that are dropped
  double clip = 5;                                      // the norm of a batch's gradient
  Objective objective = Objective::MarginalLikelihood;  // that is maximised
  double beta = 0.5;                                    // of Meritocratic
  FeedbackKind feedback = FeedbackKind::Plan;           // of the objectives that sample
  ProgramSearch search = ProgramSearch::Consistent;     // of consistent programs
  double epsilon = 0.15;                                // of the randomised beam
  std::size_t beam = 32;                                // its places
  double least = 1e-3;  // consistent programs of less prior weight, compared with the best, are left out
};

}  // namespace waymark::parser
