// Street instructions in cities never seen: leave one city out, or train on all and test on others.
//
//   exact_path  the route read is the route described, landmark by landmark
//   goal        it ends where that one ends
//   floor       exact_path of the rough count that supplies the candidates: no learning at all
//   supply      the right route is among the candidates
#pragma once
#include <vector>

#include "libparser/domain/streets/streets.hpp"
#include "libparser/experiment/folds.hpp"

namespace waymark::streets {

struct StreetScores {                               // of one city or more
  parser::Percent exact_path, goal, floor, supply;  // shares, as above
  StreetScores& operator+=(const StreetScores& other);
};

struct StreetPrediction {                          // of one instruction
  const StreetInstruction* instruction = nullptr;  // that was read
  std::vector<Mention> mentions;                   // that were found in its text
  std::vector<StreetReading> readings;             // best first
};

struct StreetEvaluation : parser::ScoresByMap<StreetScores, StreetPrediction> {  // predictions: readings cut to 3
  double mean_exact_path = 0, mean_goal = 0;                                     // over maps, in percent
};

// One map left out: trained on the other maps of `train`, tested on the instructions of `test` about this one. A map of
// `test` that `train` does not have is tested with everything in `train`; with `train_all` every map of `test` is.
// Throws std::invalid_argument when a fold has nothing to train on, Stopped when a stop was requested.
StreetEvaluation evaluate_streets(const StreetCorpus& train, const StreetCorpus& test, bool train_all, int threads,
                                  const StreetOptions& options);

}  // namespace waymark::streets
