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
#include <vector>

#include "libparser/decide.hpp"

namespace waymark::parser {

// What the chooser knows of a sentence.
class ChooserSentence {
 public:
  // `mirrored`: the tokens are a mirror image and routes are to be mirrored before they are looked at.
  ChooserSentence(const LinearModel& model, const SentenceInput& input, bool mirrored = false);

  // Features of an end: (key, value) with value 1 but for log mass.
  void features(const Executor& executor, plan::PoseId start, const Plan& plan, double mass,
                std::vector<std::pair<std::uint64_t, float>>& out) const;

 private:
  struct Property {
    std::uint64_t kind, id;
    bool with_pairs;
  };
  void route_properties(const Executor& executor, plan::PoseId start, const Plan& plan,
                        std::vector<Property>& out) const;
  void mention_features(const std::vector<Property>& properties, std::size_t moves,
                        std::vector<std::pair<std::uint64_t, float>>& out) const;

  const LinearModel* model_;
  std::vector<std::uint32_t> words_, pairs_;
  std::vector<std::uint16_t> images_;  // of propositions: the identity, or mirror images
  std::vector<bool> mentioned_;        // propositions whose thing is mentioned
  std::vector<bool> hidden_;           // propositions that may not be looked at
  std::size_t things_ = 0;             // mentioned
  std::vector<std::size_t> counts_;    // numbers named
  bool heading_unknown_, mirrored_;
};

std::uint64_t log_mass_feature();

// Scores of the ends of a decision; the ends are then sorted by probability, `mass` replaced by it.
// Does nothing when the model has no chooser.
void choose_end(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision);

}  // namespace waymark::parser
