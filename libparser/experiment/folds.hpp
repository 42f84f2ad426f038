// The experiment of every domain: in each fold a system is learned and tested on one map that it has not seen.
#pragma once
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libparser/training/parallel.hpp"

namespace waymark::parser {

struct Percent {                    // a share of counted things
  std::size_t hits = 0, total = 0;  // how many of how many
  // Per cent; 0 of nothing.
  double value() const { return total == 0 ? 0 : 100.0 * static_cast<double>(hits) / static_cast<double>(total); }
  Percent& operator+=(Percent other) {
    hits += other.hits;
    total += other.total;
    return *this;
  }
};

// Scores are sums of counts: they have +=, and {} is nothing counted.
template <class Scores, class Prediction>
struct Fold {
  std::string map;                           // tested on
  Scores scores = {};                        // on that map
  std::vector<Prediction> predictions = {};  // on that map
};

// Sums over folds.
template <class Scores, class Prediction>
struct ScoresByMap {
  std::map<std::string, Scores> folds;  // by the name of the map tested on
  Scores all;                           // weighted by counts
  std::vector<Prediction> predictions;  // in the order of the folds

  void add(Fold<Scores, Prediction>&& fold) {  // takes the predictions
    folds[fold.map] += fold.scores;
    all += fold.scores;
    predictions.insert(predictions.end(), std::make_move_iterator(fold.predictions.begin()),
                       std::make_move_iterator(fold.predictions.end()));
  }
};

// finish(fold, progress) learns and tests each fold, side by side on so many threads, of no influence on the result.
// AnyFold is a Fold<Scores, Prediction>, maybe with more; its scores stay, its predictions move to the result.
template <class Scores, class Prediction, class AnyFold, class Finish>
ScoresByMap<Scores, Prediction> run_folds(std::vector<AnyFold>& folds, int threads, const Report& report,
                                          std::string_view what, const Finish& finish) {
  run_jobs(folds.size(), threads, report, what,
           [&](std::size_t i, const JobProgress& progress) { finish(folds[i], progress); });
  ScoresByMap<Scores, Prediction> out;
  for (AnyFold& fold : folds) out.add(std::move(fold));
  return out;
}

}  // namespace waymark::parser
