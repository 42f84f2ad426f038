// The instances that tests of the networks learn from, and networks small enough to be learned in a moment.
#pragma once
#include "libparser/language/generate.hpp"
#include "libparser/training/learn.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {

inline std::span<const plan::Map> training_maps() { return std::span(shipped_maps()).first(2); }  // grid, jelly

inline Corpus training_corpus(std::size_t paragraphs) {
  return generate_corpus(training_maps(), {.seed = 1, .paragraphs = paragraphs, .sentences = 4});
}

inline TrainOptions small_options(int epochs) {
  TrainOptions options;
  options.reader = ReaderKind::EncoderDecoder;
  options.network.epochs = epochs;
  options.network.sizes = {.word = 16, .width = 16, .query = 24, .symbol = 12, .history = 4};
  options.reranker = false;
  options.beam = 16;
  return options;
}

// All sentences of a corpus, ready for learn_actions.
struct TrainingExamples {
  explicit TrainingExamples(const Corpus& corpus)
      : executors(shipped_maps().begin(), shipped_maps().end()),
        examples(make_examples(corpus, executors, Convention::Absolute)) {
    for (const Example& example : examples.sentences) all.push_back(&example);
  }
  std::vector<Executor> executors;
  Examples examples;
  std::vector<const Example*> all;
};

}  // namespace waymark::parser
