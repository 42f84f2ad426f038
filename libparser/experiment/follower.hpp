// A follower of instructions maps a sentence and a start pose to a route, or a paragraph to a sequence of routes.
#pragma once
#include <span>
#include <vector>

#include "libparser/model/features.hpp"
#include "libparser/rerank/decide.hpp"

namespace waymark::parser {

struct Response {                     // where a route leads
  plan::PoseId end;                   // of the route
  std::vector<plan::Action> actions;  // empty: stays where it is
  Program program;                    // what was read; empty when nothing was
  double probability = 0;             // that this is the end that is meant
};

class Follower {
 public:
  virtual ~Follower() = default;
  // The same answer whenever it is asked; from several threads too.
  virtual Response follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const = 0;
  // A paragraph, a sentence each: answers that begin where the answer before them ends. Here sentence after sentence,
  // each settled before the next is heard; whether the heading is unknown counts for the first alone.
  virtual std::vector<Response> follow_all(const Executor& executor, std::span<const SentenceInput> paragraph,
                                           plan::PoseId start) const;
  virtual bool reads_formulas() const { return true; }  // or does without
};

// Stays where it is, whatever it is told: what scores are worth without listening.
class StayingFollower : public Follower {
 public:
  Response follow(const Executor&, const SentenceInput&, plan::PoseId start) const override {
    return {start, {}, {}, 0};
  }
  bool reads_formulas() const override { return false; }
};

}  // namespace waymark::parser
