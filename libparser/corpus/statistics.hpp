// Statistics of a corpus: its size and the lengths of its texts and trajectories, as the table that papers print.
#pragma once
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "libparser/corpus/corpus.hpp"

namespace waymark::parser {

class CorpusStatistics {  // adds up what it is told
 public:
  void add_sequence(std::size_t sentences);  // a paragraph with so many sentences
  void add_sentence(const std::vector<std::string>& tokens,
                    std::size_t trajectory);  // its poses, or landmarks

  // Counts and means, as `waymark corpus` prints them.
  std::size_t sequences() const { return sequences_; }
  std::size_t unsegmented() const { return unsegmented_; }  // sequences without sentences
  std::size_t sentences() const { return sentences_; }
  std::size_t vocabulary() const { return words_.size(); }
  std::size_t longest_trajectory() const { return longest_; }
  double sentences_per_sequence() const { return mean(sentences_, sequences_ - unsegmented_); }
  double tokens_per_sentence() const { return mean(tokens_, sentences_); }
  double average_trajectory() const { return mean(poses_, sentences_); }

 private:
  static double mean(std::size_t sum, std::size_t count) {
    return count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
  }
  std::size_t sequences_ = 0, unsegmented_ = 0, sentences_ = 0, tokens_ = 0, poses_ = 0, longest_ = 0;
  std::set<std::string> words_;
};

struct StatisticsByMap {                           // for each map, and for all
  std::map<std::string, CorpusStatistics> by_map;  // names of maps
  CorpusStatistics all;                            // maps together
};

// Trajectories as found: an unknown heading counts as the one pose that it is.
StatisticsByMap statistics(const Corpus& corpus);

}  // namespace waymark::parser
