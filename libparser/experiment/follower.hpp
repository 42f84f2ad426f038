// Whoever follows instructions: a sentence and a pose in, a route out.
#pragma once
#include <vector>

#include "libparser/choosing/decide.hpp"
#include "libparser/reader.hpp"

namespace waymark::parser {

struct Answer {
  plan::PoseId end;
  std::vector<plan::Action> actions;  // empty: stays where it is
  Program program;                    // what was read; empty when nothing was
  double probability = 0;             // that this is the end that is meant
};

class Follower {
 public:
  virtual ~Follower() = default;
  // The same answer whenever it is asked; from several threads too.
  virtual Answer follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const = 0;
  virtual bool reads_formulas() const { return true; }  // or does without
};

// Stays where it is, whatever it is told: what scores are worth without listening.
class StayingFollower : public Follower {
 public:
  Answer follow(const Executor&, const SentenceInput&, plan::PoseId start) const override {
    return {start, {}, {}, 0};
  }
  bool reads_formulas() const override { return false; }
};

// Reads a program and carries out its plan. Several grounders vote: the probabilities of ends are averaged, and the
// first of those that give the winning end the most says how it is read.
class GroundingFollower : public Follower {
 public:
  GroundingFollower(std::vector<Grounder> grounders, const Deciding& how)
      : grounders_(std::move(grounders)), how_(how) {}
  Answer follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const override;

 private:
  std::vector<Grounder> grounders_;
  Deciding how_;
};

}  // namespace waymark::parser
