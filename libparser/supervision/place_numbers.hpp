// Numbers of places in texts: "position 5" tells where a route ends to whoever knows the numbers of the map, which
// nobody sees who walks. Hidden numbers leave the tokens of a corpus, "position 5" becomes "position", so that neither
// training nor testing hears them. A number that counts steps stays.
#pragma once
#include <string>
#include <vector>

#include "libparser/corpus/corpus.hpp"

namespace waymark::parser {

std::vector<std::string> without_place_numbers(const std::vector<std::string>& tokens);  // O(tokens)

// The tokens of all sentences; the texts stay what people wrote.
void hide_place_numbers(Corpus& corpus);

}  // namespace waymark::parser
