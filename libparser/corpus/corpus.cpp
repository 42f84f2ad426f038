#include "libparser/corpus/corpus.hpp"

namespace waymark::parser {

std::string_view name(Convention convention) { return convention == Convention::Absolute ? "absolute" : "relative"; }

std::size_t Corpus::sentences() const {
  std::size_t n = 0;
  for (const Paragraph& paragraph : paragraphs) n += paragraph.sentences.size();
  return n;
}

}  // namespace waymark::parser
