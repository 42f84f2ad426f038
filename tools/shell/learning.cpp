#include "tools/shell/learning.hpp"

#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/domain/streets/street_corpus.hpp"
#include "libparser/supervision/place_numbers.hpp"

namespace waymark::tools {

parser::Corpus read_hallway_corpus(const std::string& directory, bool tell_place_numbers) {
  if (streets::is_street_corpus(directory))
    throw ltl::FormatError(directory, 0, 0, "is a corpus of streets; only `waymark evaluate --corpus` learns from one");
  parser::Corpus corpus = parser::read_sail_corpus(directory);
  if (!tell_place_numbers) parser::hide_place_numbers(corpus);
  return corpus;
}

}  // namespace waymark::tools
