#include "libparser/model/encoder_decoder.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace waymark::parser {

using neural::Index;
using neural::Matrix;

namespace {

constexpr WordId heading_known = WordTable::begin, heading_unknown = WordTable::end;

neural::AttentionDecoder::Sizes sizes_of(const NetworkOptions& o, std::size_t symbols) {
  return {.encoded = 2 * o.width,
          .inputs = o.history * o.symbol,
          .width = o.query,
          .symbol = o.symbol,
          .symbols = static_cast<Index>(symbols)};
}

}  // namespace

EncoderDecoder::EncoderDecoder(TypedPostfix symbols, WordTable words, const NetworkOptions& options,
                               const neural::Uniform& uniform)
    : symbols_(std::move(symbols)),
      words_(std::move(words)),
      options_(options),
      phi_(parameters_.add_for_relu(options.symbol, static_cast<Index>(symbols_.symbols()) + 1, 60, uniform)),
      encoder_(parameters_, words_.words().size(), options.word, options.width, uniform),
      decoder_(parameters_, sizes_of(options, symbols_.symbols()), phi_, uniform) {}

NetworkSentence EncoderDecoder::sentence(const SentenceInput& input) const {
  NetworkSentence out;
  out.words.push_back(input.heading_unknown ? heading_unknown : heading_known);
  for (const std::string& word : input.tokens) out.words.push_back(words_.find(word));
  const SentenceFeatures features = sentence_features(input, words_);
  if (options_.lexicon)
    for (const Part& part : features.mentions) {
      const Symbol symbol = symbols_.find(part);
      if (symbol < symbols_.symbols())
        out.marked.push_back(symbol);
      else if (part.kind == PartKind::Count && part.number <= PostfixGrammar::max_forward)
        out.marked.push_back(static_cast<Symbol>(PostfixGrammar::first_forward + part.number - 1));
    }
  out.forbidden = symbols_.forbidden(features.places);
  return out;
}

History EncoderDecoder::first_history() const {
  return History(static_cast<std::size_t>(options_.history), static_cast<Symbol>(symbols_.symbols()));
}

void EncoderDecoder::remember(History& history, Symbol symbol) {
  std::copy_backward(history.begin(), history.end() - 1, history.end());
  history.front() = symbol;
}

void EncoderDecoder::Pass::encode(const EncoderDecoder& network, const neural::Parameters& parameters,
                                  std::span<const NetworkSentence* const> sentences, const Dropout& dropout) {
  network_ = &network;
  parameters_ = &parameters;
  is_attended_ = false;
  std::vector<const SentenceEncoder::Words*> words;
  for (const NetworkSentence* sentence : sentences) words.push_back(&sentence->words);
  encoder_.forward(network.encoder_, parameters, words, dropout);
  marks_.setZero(static_cast<Index>(network.symbols_.symbols()), static_cast<Index>(sentences.size()));
  for (std::size_t s = 0; s < sentences.size(); ++s)
    for (Symbol symbol : sentences[s]->marked) marks_(symbol, static_cast<Index>(s)) = 1;
}

const Matrix& EncoderDecoder::Pass::decode(std::span<const Index> begin, std::span<const History> histories) {
  begin_.assign(begin.begin(), begin.end());
  said_.clear();
  index_.clear();
  histories_.clear();
  for (const History& history : histories) {
    const auto [it, is_new] = index_.try_emplace(history, static_cast<Index>(histories_.size()));
    if (is_new) histories_.push_back(&it->first);
    said_.push_back(it->second);
  }
  const Index size = network_->options_.symbol;
  const auto phi = parameters_->value(network_->phi_);
  x_.resize(size * network_->options_.history, static_cast<Index>(histories_.size()));
  for (Index c = 0; c < x_.cols(); ++c)
    for (Index k = 0; k < network_->options_.history; ++k)
      x_.col(c).segment(k * size, size) =
          phi.col((*histories_[static_cast<std::size_t>(c)])[static_cast<std::size_t>(k)]);
  const neural::Matrix* const marks = network_->options_.lexicon ? &marks_ : nullptr;
  neural::AttentionDecoder::Sequences sequences = encoder_.sequences(begin_, said_, marks);
  sequences.is_attended = std::exchange(is_attended_, true);
  network_->decoder_.forward(*parameters_, sequences, x_, decoder_);
  return decoder_.scores;
}

void EncoderDecoder::Pass::backward(neural::Parameters& parameters, const Matrix& dscores) {
  assert(&parameters == parameters_);
  decoder_.dscores = dscores;
  dx_.resize(x_.rows(), x_.cols());
  const neural::Matrix* const marks = network_->options_.lexicon ? &marks_ : nullptr;
  network_->decoder_.backward(parameters, encoder_.sequences(begin_, said_, marks), x_, decoder_, dx_);
  const Index size = network_->options_.symbol;
  auto dphi = parameters.gradient(network_->phi_);
  for (Index c = 0; c < dx_.cols(); ++c)
    for (Index k = 0; k < network_->options_.history; ++k)
      dphi.col((*histories_[static_cast<std::size_t>(c)])[static_cast<std::size_t>(k)]) +=
          dx_.col(c).segment(k * size, size);
  encoder_.backward(parameters, decoder_.dh, decoder_.de);
}

}  // namespace waymark::parser
