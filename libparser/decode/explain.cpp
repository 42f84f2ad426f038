#include "libparser/decode/explain.hpp"

#include <cmath>

#include "libparser/model/network_scorer.hpp"

namespace waymark::parser {

std::vector<ExplainedSymbol> explain(const EncoderDecoder& network, const SentenceInput& input,
                                     const Program& program) {
  const TypedPostfix& symbols = network.symbols();
  const NetworkSentence sentence = network.sentence(input);
  const std::vector<Symbol> said = symbols.symbols_of(program);
  ChoiceMasks masks(symbols);
  std::vector<History> histories{network.first_history()};
  std::vector<const ChoiceMask*> mask;
  TypedState state;
  for (const Symbol symbol : said) {
    mask.push_back(&masks.of(state));
    state = symbols.after(state, symbol);
    histories.push_back(histories.back());
    EncoderDecoder::remember(histories.back(), symbol);
  }
  histories.pop_back();  // behind the last symbol there is no choice
  EncoderDecoder::Pass pass;
  const NetworkSentence* const only = &sentence;
  pass.encode(network, network.parameters(), {&only, 1});
  const neural::Index begin[] = {0, static_cast<neural::Index>(histories.size())};
  const neural::Matrix& scores = pass.decode(begin, histories);
  std::vector<float> log_p(symbols.symbols());
  std::vector<ExplainedSymbol> out;
  for (std::size_t i = 0; i < said.size(); ++i) {
    out.push_back({symbols.name(said[i]), 1, {}});
    if (mask[i]->forced) continue;
    const auto column = static_cast<neural::Index>(i);
    log_softmax(scores, column, *mask[i], sentence.forbidden, log_p.data());
    out.back().probability = std::exp(static_cast<double>(log_p[said[i]]));
    const neural::Matrix& attention = pass.attention().front();
    for (neural::Index word = 1; word < attention.rows(); ++word)
      out.back().weights.push_back(static_cast<double>(attention(word, column)));
  }
  return out;
}

}  // namespace waymark::parser
