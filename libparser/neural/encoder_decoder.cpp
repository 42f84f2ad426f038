#include "libparser/neural/encoder_decoder.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace waymark::parser {

using neural::Index;
using neural::Matrix;

namespace {

constexpr std::uint32_t heading_known = WordTable::begin, heading_unknown = WordTable::end;

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
      word_(parameters_.add_for_relu(options.word, static_cast<Index>(words_.words().size()), 60, uniform)),
      phi_(parameters_.add_for_relu(options.symbol, static_cast<Index>(symbols_.symbols()) + 1, 60, uniform)),
      encoder_(parameters_, options.word, options.width, uniform),
      decoder_(parameters_, sizes_of(options, symbols_.symbols()), phi_, uniform) {}

NetworkSentence EncoderDecoder::sentence(const SentenceInput& input) const {
  NetworkSentence out;
  out.words.push_back(input.heading_unknown ? heading_unknown : heading_known);
  for (const std::string& word : input.tokens) out.words.push_back(words_.find(word));
  const SentenceFeatures features = sentence_features(input, words_);
  if (options_.lexicon)
    for (const std::string& column : features.mentions) {
      const Symbol symbol = symbols_.find(column);
      if (symbol < symbols_.symbols()) {
        out.marked.push_back(symbol);
      } else if (column.rfind("count ", 0) == 0) {
        const int count = std::stoi(column.substr(6));
        if (count >= 1 && count <= PostfixGrammar::max_forward)
          out.marked.push_back(static_cast<Symbol>(PostfixGrammar::first_forward + count - 1));
      }
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

void EncoderDecoder::Pass::drop(Matrix& signals, Matrix& mask, const Dropout& dropout) const {
  mask.resize(0, 0);
  if (dropout.signals <= 0) return;
  const auto kept = static_cast<float>(1 / (1 - dropout.signals));
  mask.resize(signals.rows(), signals.cols());
  for (Index i = 0; i < mask.size(); ++i) mask.data()[i] = dropout.uniform() < dropout.signals ? 0.0F : kept;
  signals.array() *= mask.array();
}

void EncoderDecoder::Pass::encode(const EncoderDecoder& network, const neural::Parameters& parameters,
                                  std::span<const NetworkSentence* const> sentences, const Dropout& dropout) {
  network_ = &network;
  parameters_ = &parameters;
  order_.resize(sentences.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return sentences[a]->words.size() > sentences[b]->words.size();
  });
  std::vector<Index> lengths;
  for (std::size_t s : order_) lengths.push_back(static_cast<Index>(sentences[s]->words.size()));
  packing_ = neural::Packing(lengths);
  std::vector<Index> place(sentences.size());
  for (std::size_t i = 0; i < order_.size(); ++i) place[order_[i]] = static_cast<Index>(i);

  words_.resize(static_cast<std::size_t>(packing_.columns()));
  columns_of_words_.clear();
  h_begin_ = {0};
  for (std::size_t s = 0; s < sentences.size(); ++s) {
    for (std::size_t t = 0; t < sentences[s]->words.size(); ++t) {
      const Index column = packing_.column(place[s], static_cast<Index>(t));
      columns_of_words_.push_back(column);
      const bool unread = t > 0 && dropout.words > 0 && dropout.uniform() < dropout.words;
      words_[static_cast<std::size_t>(column)] = unread ? WordTable::unknown : sentences[s]->words[t];
    }
    h_begin_.push_back(static_cast<Index>(columns_of_words_.size()));
  }
  embedded_.resize(network.options_.word, packing_.columns());
  for (Index c = 0; c < packing_.columns(); ++c)
    embedded_.col(c) = parameters.value(network.word_).col(words_[static_cast<std::size_t>(c)]);
  drop(embedded_, embedded_mask_, dropout);
  network.encoder_.forward(parameters, packing_, embedded_, encoder_);

  h_.resize(network.encoder_.width(), packing_.columns());
  for (Index c = 0; c < packing_.columns(); ++c)
    h_.col(c) = encoder_.h.col(columns_of_words_[static_cast<std::size_t>(c)]);
  drop(h_, h_mask_, dropout);
  e_.resize(network.encoder_.width(), static_cast<Index>(sentences.size()));
  for (std::size_t s = 0; s < sentences.size(); ++s)
    e_.col(static_cast<Index>(s)) = encoder_.last.col(place[s]);
  marks_.setZero(static_cast<Index>(network.symbols_.symbols()), static_cast<Index>(sentences.size()));
  for (std::size_t s = 0; s < sentences.size(); ++s)
    for (Symbol symbol : sentences[s]->marked) marks_(symbol, static_cast<Index>(s)) = 1;
}

neural::AttentionDecoder::Sequences EncoderDecoder::Pass::sequences() const {
  return {&h_, h_begin_, &e_, network_->options_.lexicon ? &marks_ : nullptr, begin_};
}

const Matrix& EncoderDecoder::Pass::decode(std::span<const Index> begin, std::span<const History> histories) {
  begin_.assign(begin.begin(), begin.end());
  histories_.assign(histories.begin(), histories.end());
  const Index size = network_->options_.symbol;
  const auto phi = parameters_->value(network_->phi_);
  x_.resize(size * network_->options_.history, static_cast<Index>(histories.size()));
  for (Index c = 0; c < x_.cols(); ++c)
    for (Index k = 0; k < network_->options_.history; ++k)
      x_.col(c).segment(k * size, size) =
          phi.col(histories[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)]);
  network_->decoder_.forward(*parameters_, sequences(), x_, decoder_);
  return decoder_.scores;
}

void EncoderDecoder::Pass::backward(neural::Parameters& parameters, const Matrix& dscores) {
  assert(&parameters == parameters_);
  decoder_.dscores = dscores;
  dx_.resize(x_.rows(), x_.cols());
  network_->decoder_.backward(parameters, sequences(), x_, decoder_, dx_);
  const Index size = network_->options_.symbol;
  auto dphi = parameters.gradient(network_->phi_);
  for (Index c = 0; c < dx_.cols(); ++c)
    for (Index k = 0; k < network_->options_.history; ++k)
      dphi.col(histories_[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)]) +=
          dx_.col(c).segment(k * size, size);
  if (h_mask_.size() > 0) decoder_.dh.array() *= h_mask_.array();
  encoder_.dh.resize(h_.rows(), h_.cols());
  for (Index c = 0; c < h_.cols(); ++c)
    encoder_.dh.col(columns_of_words_[static_cast<std::size_t>(c)]) = decoder_.dh.col(c);
  encoder_.dlast.resize(e_.rows(), e_.cols());
  for (std::size_t i = 0; i < order_.size(); ++i)
    encoder_.dlast.col(static_cast<Index>(i)) = decoder_.de.col(static_cast<Index>(order_[i]));
  dembedded_.resize(embedded_.rows(), embedded_.cols());
  network_->encoder_.backward(parameters, packing_, embedded_, encoder_, dembedded_);
  if (embedded_mask_.size() > 0) dembedded_.array() *= embedded_mask_.array();
  auto dwords = parameters.gradient(network_->word_);
  for (Index c = 0; c < dembedded_.cols(); ++c)
    dwords.col(words_[static_cast<std::size_t>(c)]) += dembedded_.col(c);
}

}  // namespace waymark::parser
