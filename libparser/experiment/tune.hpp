// Validation of settings: learn from one training map, test on another. A map that an experiment leaves out is in no
// pair that counts for it.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "libparser/experiment/evaluate.hpp"

namespace waymark::parser {

struct ValidationPair {         // a map that is learned from and one that is tested
  std::size_t learned, tested;  // maps
  Percent sentence;             // under the convention of the options
};

// Where pairs are kept, if anywhere: those that were learned from one map are a part.
struct KeptPairs {
  const Checkpoints* checkpoints = nullptr;  // nullptr: nowhere
  std::string setting = {};                  // what the names of the parts begin with
};

// All ordered pairs of maps with sentences. Readers decide alone, without a reranker: to learn one takes two maps.
// Throws std::invalid_argument when fewer than two maps have paragraphs; Stopped when a stop was requested.
std::vector<ValidationPair> validate(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options,
                                     const KeptPairs& kept = {});

// Makes the parts of it that nobody has made or begun, and waits for nobody. Throws as validate.
void help_to_validate(const Corpus& corpus, std::span<const plan::Map> maps, const TrainOptions& options,
                      const KeptPairs& kept);

// Of the pairs that do not touch a map, together.
Percent without_map(std::span<const ValidationPair> pairs, std::size_t left_out);

}  // namespace waymark::parser
