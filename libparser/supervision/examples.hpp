// A corpus made ready for learning: every sentence with its gold route on its map and its consistent programs.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libparser/corpus/corpus.hpp"
#include "libparser/model/features.hpp"
#include "libparser/supervision/judged.hpp"
#include "libparser/supervision/search.hpp"

namespace waymark::parser {

struct Example {
  SentenceInput input;                                      // what a model is told
  std::size_t map = 0;                                      // index of its map
  GoldRoute gold;                                           // that people took
  std::shared_ptr<const std::vector<Consistent>> programs;  // shared by equal routes on one map
  std::size_t paragraph = 0, position = 0;                  // index in the corpus, and of the sentence in it
  Judged judged = {};                                       // trajectories with a verdict
};

// Does the second follow the first in its paragraph, from where the first ended?
inline bool goes_on(const Example& first, const Example& second) {
  return first.paragraph == second.paragraph && first.position + 1 == second.position &&
         first.gold.end == second.gold.start;
}

struct Examples {                      // a corpus that is ready
  std::vector<Example> sentences;      // in the order of the corpus
  std::vector<std::size_t> paragraph;  // of each sentence: index in the corpus
  std::vector<std::string> ids;        // of each sentence
};

// The words of the sentences that occur twice: from one occurrence there is nothing to learn. With both sides, for
// mirror images.
WordTable words_met_twice(std::span<const Example* const> examples);

struct Stopped {};  // thrown by long work when a stop was requested

// Sentences of the paragraphs that lie on one of the executors' maps.
// Throws std::invalid_argument naming the sentence when a gold trajectory is impossible on its map.
Examples make_examples(const Corpus& corpus, std::span<const Executor> executors, Convention convention);

// Fills `programs`, on so many threads, with those that agree with the judged trajectories. The result does not depend
// on the number of threads.
void find_programs(std::span<Example> examples, std::span<const Executor> executors, const PostfixGrammar& grammar,
                   int threads, const std::function<bool(double fraction)>& go_on);

}  // namespace waymark::parser
