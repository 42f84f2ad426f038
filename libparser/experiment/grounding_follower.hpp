// The follower that grounds: it reads programs and carries out their plans.
//
// Several grounders vote: the probabilities of ends are averaged, and the first of those that give the winning end the
// most says how it is read.
//
// Along a paragraph several poses are kept alive, and what is said next tells which of them was meant:
//   P_k(end) = Σ_start P_{k−1}(start) · e^(trust · evidence_k(start)) · p_k(end | start),   the `alive` likeliest kept
// with p_k as of a single sentence and the evidence of the locators (chooser.hpp), a mean over the grounders. The answer ends at
// the place that is likeliest after the last sentence, by the likeliest way there. With one pose alive this is Follower's own
// way: sentence after sentence.
#pragma once
#include "libparser/experiment/follower.hpp"

namespace waymark::parser {

struct Following {
  Deciding deciding = {};
  std::size_t alive = 12;        // poses, along a paragraph; at least 1
  double trust_in_locator = 0.5;  // its weight beside the chooser's probabilities
};

class GroundingFollower : public Follower {
 public:
  GroundingFollower(std::vector<Grounder> grounders, const Following& how)
      : grounders_(std::move(grounders)), how_(how) {}
  Answer follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const override;
  // O(sentences · alive · what one sentence costs); a sentence is read once for all poses.
  std::vector<Answer> follow_all(const Executor& executor, std::span<const SentenceInput> paragraph,
                                 plan::PoseId start) const override;

  // What a sentence comes to from one start: answers, of which the most probable first; probabilities sum to 1, or there is none.
  struct Verdict {
    std::vector<Answer> answers;
    double evidence = 0;  // of the start, up to one constant for each sentence
  };
  using Readings = std::vector<std::vector<Weighed>>;  // by grounder
  Readings read(const SentenceInput& input) const;
  Verdict judge(const Executor& executor, const SentenceInput& input, const Readings& readings,
                plan::PoseId start) const;

 private:
  std::vector<Grounder> grounders_;
  Following how_;
};

}  // namespace waymark::parser
