// Learning to read lifted texts from texts with their lifted formulas: maximum likelihood by Adam.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "libparser/lifted/lifted_network.hpp"

namespace waymark::parser {

struct LiftedExample {  // a text with its formula
  LiftedText text;      // that is read
  Lifted lifted;        // that it means
  double weight = 1;    // how often it is drawn, compared with others
};

// Texts that are read in the mirror, mirrored with their formulas.
std::vector<LiftedExample> upright(std::span<const LiftedExample> examples);

struct LiftedTraining {    // of one network
  LiftedSizes sizes = {};  // of its layers
  std::uint64_t seed = 1;  // of all randomness
  int epochs = 5;          // over all examples
  std::size_t batch = 32;  // examples of a step
  // Of Adam; shares that are dropped; the norm of a gradient.
  double rate = 3e-3, dropout = 0.2, word_dropout = 0.05, clip = 5;
  double other_commas = 0.15;  // share of examples that are read with the commas after their slots changed
  std::size_t threads = 2;     // no influence on the result
};

// An epoch draws as many examples as there are, by weight. Examples must be spelled in their scope. The seed fixes the
// bytes, whatever the number of threads. progress: the share that is done.
std::shared_ptr<const LiftedNetwork> learn_lifted(std::span<const LiftedExample> examples,
                                                  std::shared_ptr<const WordVectors> vectors,
                                                  const LiftedTraining& options,
                                                  const std::function<void(double)>& progress = {});

}  // namespace waymark::parser
