// How many texts a process is given at a time: as many as take about `seconds`, measured on those that were answered.
//
// The first chunk has one text, and a chunk at most twice as many as the one before, so that a corpus that begins with
// hard texts is shared out as soon as one that begins with easy ones. Who answers gives back what is left of a chunk
// when its time is over: a chunk takes so many seconds and one text at most, whatever was expected of it.
#pragma once
#include <cstddef>

namespace waymark::tools {

class ChunkSize {
 public:
  explicit ChunkSize(double seconds) : seconds_(seconds) {}

  std::size_t texts() const { return texts_; }  // of the next chunk
  void learn(std::size_t texts, double took);   // a chunk was answered, in so many seconds

  static constexpr std::size_t most_texts = 65'536;

 private:
  double seconds_;
  double each_ = 0;  // seconds a text: half of it is of the last chunk, a quarter of the one before, …
  std::size_t texts_ = 1;
};

// $WAYMARK_CHUNK_SECONDS, or half a second. Throws UsageError when it is no number of at least 0.
double chunk_seconds();

}  // namespace waymark::tools
