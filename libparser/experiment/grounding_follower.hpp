// The follower that grounds: it reads programs and carries out their plans.
//
// Several grounders vote: the probabilities of ends are averaged, and the first of those that give the winning end the
// most says how it is read. Paragraphs are read as a whole (rerank/paragraph.hpp); evidence is a mean over the
// grounders.
#pragma once
#include "libparser/experiment/follower.hpp"
#include "libparser/rerank/paragraph.hpp"

namespace waymark::parser {

struct Following {                  // how readings become routes
  Deciding deciding = {};           // of one sentence
  ParagraphOptions paragraph = {};  // of a paragraph
};

class GroundingFollower : public Follower {
 public:
  GroundingFollower(std::vector<Grounder> grounders, const Following& how)
      : grounders_(std::move(grounders)), how_(how) {}
  Response follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const override;
  // O(sentences · hypotheses · what one sentence costs); a sentence is read once for all poses.
  std::vector<Response> follow_all(const Executor& executor, std::span<const SentenceInput> paragraph,
                                   plan::PoseId start) const override;

  // What a sentence comes to from one start: answers, of which the most probable first; probabilities sum to 1, or
  // there is none.
  struct Verdict {
    std::vector<Response> answers;  // best first
    double evidence = 0;            // of the start, up to one constant for each sentence
  };
  using Readings = std::vector<std::vector<Weighed>>;  // by grounder
  Readings read(const SentenceInput& input) const;     // of every grounder
  // Of one start.
  Verdict judge(const Executor& executor, const SentenceInput& input, const Readings& readings,
                plan::PoseId start) const;

 private:
  std::vector<Grounder> grounders_;
  Following how_;
};

}  // namespace waymark::parser
