#include "libparser/corpus/statistics.hpp"

#include <algorithm>

namespace waymark::parser {

void CorpusStatistics::add_sequence(std::size_t sentences) {
  ++sequences_;
  if (sentences == 0) ++unsegmented_;
}

void CorpusStatistics::add_sentence(const std::vector<std::string>& tokens, std::size_t trajectory) {
  ++sentences_;
  tokens_ += tokens.size();
  poses_ += trajectory;
  longest_ = std::max(longest_, trajectory);
  words_.insert(tokens.begin(), tokens.end());
}

StatisticsByMap statistics(const Corpus& corpus) {
  StatisticsByMap out;
  for (const Paragraph& paragraph : corpus.paragraphs)
    for (CorpusStatistics* one : {&out.by_map[paragraph.map], &out.all}) {
      one->add_sequence(paragraph.sentences.size());
      // The relative trajectory puts one turn where the source leaves the heading open: as many poses as it has.
      for (const Sentence& sentence : paragraph.sentences) one->add_sentence(sentence.tokens, sentence.relative.size());
    }
  return out;
}

}  // namespace waymark::parser
