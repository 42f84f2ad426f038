#include "tools/attention.hpp"

#include <variant>

#include "libparser/corpus/token.hpp"
#include "libparser/model/word_model.hpp"
#include "libparser/rerank/decide.hpp"

namespace waymark::tools {

const parser::EncoderDecoder* network_of(const parser::Grounder& model) {
  const auto* network = std::get_if<std::shared_ptr<const parser::NetworkModel>>(&model.word_model);
  return network == nullptr ? nullptr : &(*network)->network;
}

std::vector<Attended> attended(const parser::Grounder& model, const std::string& text, bool heading_unknown,
                               std::size_t beam) {
  std::vector<Attended> out;
  for (const std::string& sentence : parser::split_sentences(text)) {
    const parser::SentenceInput input{parser::tokenize(sentence), heading_unknown && out.empty()};
    const auto programs = parser::likely_programs(model, input, {.beam = beam});
    if (!programs.empty())
      out.push_back({input.tokens, parser::explain(*network_of(model), input, programs.front().program)});
  }
  return out;
}

JsonArray json_of(std::span<const Attended> sentences) {
  JsonArray out;
  for (const Attended& sentence : sentences) {
    JsonArray words, symbols;
    for (const std::string& word : sentence.words) words.add(word);
    for (const parser::ExplainedSymbol& symbol : sentence.symbols) {
      JsonArray weights;
      for (const double weight : symbol.weights) weights.add(weight);
      symbols.add(
          JsonObject().add("symbol", symbol.symbol).add("probability", symbol.probability).add("attention", weights));
    }
    out.add(JsonObject().add("words", words).add("symbols", symbols));
  }
  return out;
}

}  // namespace waymark::tools
