// Learning to choose: a softmax over options, of which some are right.
//
//   of ends     the options are the ends of a sentence's candidates from its gold start; right is the gold end
//   of starts   the options are the ends from the gold start and from a few poses where the sentence before could have ended
//               instead; right is whatever begins at the gold start
// The candidates must come from a reader that has not learned from the sentence (learn.cpp leaves out the whole map), or
// the chooser would learn to trust probabilities that are too good. The end pose of a candidate is right or wrong:
// that is all the supervision there is.
#pragma once
#include <span>
#include <vector>

#include "libparser/choosing/chooser.hpp"
#include "libparser/learn.hpp"

namespace waymark::parser {

// A sentence with two options or more, some right and some not.
struct Dilemma {
  const Example* example;
  struct Option {
    plan::PoseId start;
    Plan plan;
    double mass;
  };
  std::vector<Option> options;
  std::vector<std::size_t> right;  // ascending
};

struct Dilemmas {
  std::vector<Dilemma> of_ends, of_starts;
  void add(Dilemmas&& more);
};

// Examples in the order of their paragraphs; the dilemmas point at them. Added to what is there.
void add_dilemmas(const Grounder& reader, std::span<const Example* const> examples,
                  std::span<const Executor> executors, const TrainOptions& options, Dilemmas& dilemmas);

// The same reader with a chooser and a locator learned for it.
Grounder with_chooser(const Grounder& reader, const Dilemmas& dilemmas, std::span<const Executor> executors,
                      const TrainOptions& options, const JobProgress& progress);

}  // namespace waymark::parser
