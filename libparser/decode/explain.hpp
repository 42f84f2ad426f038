// The attention of an encoder-decoder: for each symbol of a program, the weights of the words of the sentence.
#pragma once
#include <string>
#include <vector>

#include "libparser/model/encoder_decoder.hpp"

namespace waymark::parser {

struct ExplainedSymbol {        // one row of attention
  std::string symbol;           // its name
  double probability = 0;       // of this symbol here; 1 where the grammar leaves no choice
  std::vector<double> weights;  // of the words of the sentence; they sum to less than 1: the rest lies on what stands
                                // before the first word. Empty where there was no choice
};

// O(symbols) choices in one pass. Throws std::invalid_argument when the program is not in the decoder's language.
std::vector<ExplainedSymbol> explain(const EncoderDecoder& network, const SentenceInput& input, const Program& program);

}  // namespace waymark::parser
