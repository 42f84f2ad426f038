// Learning to choose: a softmax over the ends of a sentence's candidates, of which one is the gold end.
//
// The candidates must come from a reader that has not learned from the sentence (learn.cpp leaves out the whole map), or
// the chooser would learn to trust probabilities that are too good. The end pose of a candidate is right or wrong:
// that is all the supervision there is.
#pragma once
#include <span>
#include <vector>

#include "libparser/choosing/chooser.hpp"
#include "libparser/learn.hpp"

namespace waymark::parser {

// A sentence with two ends or more, the gold one among them.
struct Dilemma {
  const Example* example;
  struct Option {
    Plan plan;
    double mass;
  };
  std::vector<Option> options;
  std::size_t gold;
};

std::vector<Dilemma> dilemmas_of(const Grounder& reader, std::span<const Example* const> examples,
                                 std::span<const Executor> executors, const TrainOptions& options);

void learn_chooser(LinearModel& model, std::span<const Dilemma* const> dilemmas,
                   std::span<const Executor> executors, const TrainOptions& options,
                   const JobProgress& progress);

// The same reader with a chooser learned for it.
Grounder with_chooser(const Grounder& reader, std::span<const Dilemma* const> dilemmas,
                      std::span<const Executor> executors, const TrainOptions& options,
                      const JobProgress& progress);

}  // namespace waymark::parser
