// The features of routes that the reranker and the start-pose model weigh (reranker.hpp).
//
//   whole route   its actions; the actions without repetitions; numbers of moves, turns, runs and crossings
//   poses         what holds at its end, for the first time there or how often before; before the first move;
//                 what is walked over; what is ahead while walking, and in the last run; where a turn follows a move
// Each feature counts alone and with every word of the sentence, some with pairs of words. Further features say how
// many of the mentioned things are met, and whether numbers in the sentence equal the moves. Place numbers count only
// where the sentence names them. Where the first heading is unknown, no word stands for the turns before the first
// move: these turns are one feature, and the other features leave them out.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "libparser/rerank/decide.hpp"
#include "libparser/rerank/ranker.hpp"

namespace waymark::parser {

// The only feature whose value is not 1: the logarithm of an end's mass.
std::uint64_t log_mass_feature();

// What is known of a sentence, and the ends that are compared. What a route is like (a property) goes with every word:
// such a bundle of features is the same for all ends that share the property.
class RerankerSentence {
 public:
  // `mirrored`: the tokens are a mirror image and routes are to be mirrored before they are looked at.
  // The model (its words and columns) must outlive it.
  RerankerSentence(const RankingModel& model, const SentenceInput& input, bool mirrored = false);

  // Adds one more end: where `plan` leads from `start`. O(actions · |AP| + new properties · words).
  void add_end(const Executor& executor, plan::PoseId start, const Plan& plan, double mass);
  CandidateFeatures take() { return std::move(features_); }

 private:
  struct Property {
    std::uint64_t kind, id;
    bool with_pairs;
  };
  struct Walk;  // a route, as it is looked at
  Walk walk_of(const Executor& executor, plan::PoseId start, const Plan& plan) const;
  void add_shape(const Walk& walk, std::vector<Property>& out) const;
  void add_sights(const Executor& executor, const Walk& walk, std::vector<Property>& out) const;
  void add_mentions(const std::vector<Property>& properties, std::size_t moves);
  void add_to_last_end(std::uint64_t key, const Property* with_words);

  const RankingModel* model_;
  std::vector<std::uint32_t> words_, pairs_;
  std::vector<std::uint16_t> images_;  // of propositions: the identity, or mirror images
  std::vector<bool> mentioned_;        // propositions whose thing is mentioned
  std::vector<bool> hidden_;           // propositions that may not be looked at
  std::size_t things_ = 0;             // mentioned
  std::vector<std::size_t> counts_;    // numbers named
  bool heading_unknown_, mirrored_;
  CandidateFeatures features_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;  // of bundles, by their first key
};

}  // namespace waymark::parser
