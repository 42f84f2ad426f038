// Corpora as text: JSON Lines, which read_sail_corpus reads back, and pairs of sentence and formula.
#pragma once
#include <string>

#include "libparser/corpus/corpus.hpp"

namespace waymark::parser {

// One paragraph a line; sentences with `formula` where it is known. Start headings must be known (asserted).
std::string json_lines(const Corpus& corpus);

// sentence TAB formula, for every sentence whose formula is known.
std::string pairs_text(const Corpus& corpus);

}  // namespace waymark::parser
