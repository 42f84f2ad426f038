// Which words of a sentence each symbol of its likeliest program attended to.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "libparser/decode/explain.hpp"
#include "libparser/decode/grounder.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

// A sentence as the reader says it, symbol by symbol.
struct Attended {
  std::vector<std::string> words;
  std::vector<parser::ExplainedSymbol> symbols;
};

// The encoder-decoder of the model, nullptr when it has a model of another kind.
const parser::EncoderDecoder* network_of(const parser::Grounder& model);

// The likeliest program of each sentence, before the map has its say. The model has an encoder-decoder.
std::vector<Attended> attended(const parser::Grounder& model, const std::string& text, bool heading_unknown,
                               std::size_t beam = 64);
JsonArray json_of(std::span<const Attended> sentences);

}  // namespace waymark::tools
