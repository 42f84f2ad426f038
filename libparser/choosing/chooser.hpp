// The chooser: which of the ends that candidate programs lead to is meant, judged by the routes there.
//
//   p(end | sentence) ∝ exp(a · log mass(end) + w · f(sentence, route))
// The reader knows words and programs, the chooser also sees what a route does and passes: its actions, what is true
// where it ends, what is true there for the first time, what it walked over; each with the words of the sentence, and
// whether the sentence mentions it. Place numbers count only where the sentence names them. Trained on the same
// trajectories as the reader, on candidates of readers that had not seen the map: learn_chooser.hpp.
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "libparser/choosing/decide.hpp"

namespace waymark::parser {

// Features of all ends of one decision. What a route is like (a property) goes with every word: such a bundle of features
// is the same for all ends that share the property, so it is listed and weighed once.
struct EndFeatures {
  std::vector<std::vector<std::uint64_t>> bundles;  // keys
  std::vector<std::vector<std::uint32_t>> ends;     // bundles of each end; one may count twice
  std::vector<float> log_mass;                      // of each end, the value of log_mass_feature()
};
std::uint64_t log_mass_feature();

// What the chooser knows of a sentence.
class ChooserSentence {
 public:
  // `mirrored`: the tokens are a mirror image and routes are to be mirrored before they are looked at.
  ChooserSentence(const LinearModel& model, const SentenceInput& input, bool mirrored = false);

  // Adds one more end: where `plan` leads from `start`.
  void add_end(const Executor& executor, plan::PoseId start, const Plan& plan, double mass);
  EndFeatures take() { return std::move(features_); }

 private:
  struct Property {
    std::uint64_t kind, id;
    bool with_pairs;
  };
  std::vector<Property> route_properties(const Executor& executor, plan::PoseId start,
                                         const Plan& plan) const;
  void add_mentions(const std::vector<Property>& properties, std::size_t moves);
  void add_to_last_end(std::uint64_t key, const Property* with_words);

  const LinearModel* model_;
  std::vector<std::uint32_t> words_, pairs_;
  std::vector<std::uint16_t> images_;  // of propositions: the identity, or mirror images
  std::vector<bool> mentioned_;        // propositions whose thing is mentioned
  std::vector<bool> hidden_;           // propositions that may not be looked at
  std::size_t things_ = 0;             // mentioned
  std::vector<std::size_t> counts_;    // numbers named
  bool heading_unknown_, mirrored_;
  EndFeatures features_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;  // of bundles, by their first key
};

// Scores of the ends of a decision; the ends are then sorted by probability, `mass` replaced by it.
// Does nothing when the model has no chooser.
void choose_end(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision);

}  // namespace waymark::parser
