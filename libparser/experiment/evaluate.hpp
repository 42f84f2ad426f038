// Scores of a grounding model against trajectories, in percent, and the experiment that leaves one map out.
//
//   sentence     end node and heading equal the gold ones, from the gold start pose
//   paragraph    all sentences from the gold start pose of the first, each from the end of the last one; the end node
//                equals the gold one of the last sentence. Unsegmented paragraphs are skipped and counted
//   path         sets of visited nodes without the start node: precision and recall over all sentences (micro),
//                accuracy over all (sentence, node other than the start) pairs, under the absolute convention; the same
//                along whole paragraphs
//   unheard      like sentence, of those whose sequence of tokens no sentence of the training maps has
//   satisfiable  sentences whose formula has a plan on the map from the gold start pose; only of followers that read
//                formulas. All formulas are well typed, since no others can be decoded
// A model is trained and tested under the same convention.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "libparser/experiment/checkpoints.hpp"
#include "libparser/experiment/folds.hpp"
#include "libparser/experiment/grounding_follower.hpp"
#include "libparser/training/learn.hpp"

namespace waymark::parser {

struct ConventionScores {      // under both conventions
  Percent absolute, relative;  // shares
};

// Sets of nodes walked over, the start node left out.
struct PathScores {
  Percent precision, recall, accuracy;  // of places on paths
  PathScores& operator+=(const PathScores& other);
};

struct Scores {                                   // of one map or more
  ConventionScores sentence, paragraph, unheard;  // as above; sentences that no training map has
  PathScores path, paragraph_path;                // under the absolute convention
  Percent satisfiable;                 // sentences with a formula that can be satisfied on the map from their start
  std::size_t skipped_paragraphs = 0;  // unsegmented
  Scores& operator+=(const Scores& other);
};

// The token sequences that a follower was trained on.
using HeardSentences = std::set<std::vector<std::string>>;

// One sentence that was tested: by itself, from its gold start, or in its paragraph, from where the one before it had
// ended.
struct Prediction {
  std::string id, map;                        // of the sentence
  Convention convention;                      // of its trajectory
  plan::PoseId start, gold_end;               // poses
  Response answer;                            // of the follower
  std::optional<std::string> paragraph = {};  // its id; nothing: by itself
};

struct Evaluation : ScoresByMap<Scores, Prediction> {  // without predictions of folds whose scores had been kept
  std::vector<Scores> singles;                         // of an ensemble: all folds of each member
  double seconds = 0;                                  // of training and testing
};

struct EvaluateOptions {                  // what is compared
  TrainOptions train = {};                // its convention is ignored: both are trained and reported
  bool absolute = true, relative = true;  // which conventions to run
  bool actions = false;                   // the baseline without formulas instead of what `train` says
  // Who carries out what the systems read; nobody: their own plans count.
  std::function<std::shared_ptr<const Follower>(std::shared_ptr<const Follower>)> carried_out = {};
  std::size_t ensemble = 1;  // systems of seeds train.seed, train.seed + 1, …
  // Where finished readers, rerankers and scores are kept, if anywhere: a run that finds them there goes on from them,
  // to the same scores as one that was never stopped. Tables of weights are rounded as in a model file then.
  const Checkpoints* checkpoints = nullptr;
  std::string system = {};  // with which the names of those parts begin
};

// For each map: train on the paragraphs of the others, test on its own (those of `test` when given).
// Throws std::invalid_argument when fewer than two maps have paragraphs; Stopped when a stop was requested.
Evaluation evaluate_leave_one_map_out(const Corpus& train, const Corpus* test, std::span<const plan::Map> maps,
                                      const EvaluateOptions& options = {});

// Trains on all of one corpus and tests on another, map by map; an ensemble votes. Throws as `train` does.
Evaluation evaluate_train_all(const Corpus& train, std::span<const plan::Map> maps, const Corpus& test,
                              std::span<const plan::Map> test_maps, const EvaluateOptions& options = {});

// The systems as one follower, carried out as the options say.
std::shared_ptr<const Follower> follower_of(std::vector<Grounder> systems, const EvaluateOptions& options);
Following following(const TrainOptions& options);

// Scores of one follower, under the convention it is asked about, on the paragraphs of the corpus that lie on this map.
// Predictions are added when they are wanted. Without heard sentences, none are counted as unheard. Throws Stopped
// when a stop was requested.
Scores evaluate(const Follower& follower, const Corpus& corpus, const plan::Map& map, Convention convention,
                std::vector<Prediction>* predictions = nullptr, std::stop_token stop = {},
                const HeardSentences* heard = nullptr);

}  // namespace waymark::parser
