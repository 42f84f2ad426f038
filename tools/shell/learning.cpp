#include "tools/shell/learning.hpp"

#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/domain/streets/street_corpus.hpp"

namespace waymark::tools {

parser::Corpus read_hallway_corpus(const std::string& directory) {
  if (streets::is_street_corpus(directory))
    throw ltl::FormatError(directory, 0, 0,
                           "is a corpus of streets; only `waymark evaluate --corpus` learns from one");
  return parser::read_sail_corpus(directory);
}

}  // namespace waymark::tools
