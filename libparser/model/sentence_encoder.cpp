#include "libparser/model/sentence_encoder.hpp"

#include <algorithm>
#include <numeric>

namespace waymark::parser {

using neural::Index;
using neural::Matrix;

namespace {

// Leaves signals out and makes up for it; `mask` is empty when nothing is left out.
void drop(Matrix& signals, Matrix& mask, const Dropout& dropout) {
  mask.resize(0, 0);
  if (dropout.signals <= 0) return;
  const auto kept = static_cast<float>(1 / (1 - dropout.signals));
  mask.resize(signals.rows(), signals.cols());
  for (Index i = 0; i < mask.size(); ++i) mask.data()[i] = dropout.uniform() < dropout.signals ? 0.0F : kept;
  signals.array() *= mask.array();
}

}  // namespace

SentenceEncoder::SentenceEncoder(neural::Parameters& parameters, std::size_t words, Index word, Index width,
                                 const neural::Uniform& uniform)
    : words_(parameters.add_for_relu(word, static_cast<Index>(words), 60, uniform)),  // small: ±0.3
      lstm_(parameters, word, width, uniform) {}

void SentenceEncoder::Pass::place(std::span<const Words* const> sentences, const Dropout& dropout) {
  order_.resize(sentences.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return sentences[a]->size() > sentences[b]->size(); });
  std::vector<Index> lengths, rank(sentences.size());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    lengths.push_back(static_cast<Index>(sentences[order_[i]]->size()));
    rank[order_[i]] = static_cast<Index>(i);
  }
  packing_ = neural::Packing(lengths);
  words_.resize(static_cast<std::size_t>(packing_.columns()));
  column_.clear();
  h_begin_ = {0};
  for (std::size_t s = 0; s < sentences.size(); ++s) {
    for (std::size_t t = 0; t < sentences[s]->size(); ++t) {
      column_.push_back(packing_.column(rank[s], static_cast<Index>(t)));
      const bool unread = t > 0 && dropout.words > 0 && dropout.uniform() < dropout.words;
      words_[static_cast<std::size_t>(column_.back())] = unread ? WordTable::unknown : (*sentences[s])[t];
    }
    h_begin_.push_back(static_cast<Index>(column_.size()));
  }
}

void SentenceEncoder::Pass::forward(const SentenceEncoder& encoder, const neural::Parameters& parameters,
                                    std::span<const Words* const> sentences, const Dropout& dropout) {
  encoder_ = &encoder;
  place(sentences, dropout);
  const auto table = parameters.value(encoder.words_);
  embedded_.resize(table.rows(), packing_.columns());
  for (Index c = 0; c < packing_.columns(); ++c)
    embedded_.col(c) = table.col(words_[static_cast<std::size_t>(c)].index);
  drop(embedded_, embedded_mask_, dropout);
  encoder.lstm_.forward(parameters, packing_, embedded_, lstm_);
  h_.resize(encoder.width(), packing_.columns());
  for (Index c = 0; c < packing_.columns(); ++c) h_.col(c) = lstm_.h.col(column_[static_cast<std::size_t>(c)]);
  drop(h_, h_mask_, dropout);
  e_.resize(encoder.width(), static_cast<Index>(sentences.size()));
  for (std::size_t i = 0; i < order_.size(); ++i)
    e_.col(static_cast<Index>(order_[i])) = lstm_.last.col(static_cast<Index>(i));
}

void SentenceEncoder::Pass::backward(neural::Parameters& parameters, Matrix& dh, const Matrix& de) {
  if (h_mask_.size() > 0) dh.array() *= h_mask_.array();
  lstm_.dh.resize(h_.rows(), h_.cols());
  for (Index c = 0; c < h_.cols(); ++c) lstm_.dh.col(column_[static_cast<std::size_t>(c)]) = dh.col(c);
  lstm_.dlast.resize(e_.rows(), e_.cols());
  for (std::size_t i = 0; i < order_.size(); ++i)
    lstm_.dlast.col(static_cast<Index>(i)) = de.col(static_cast<Index>(order_[i]));
  dembedded_.resize(embedded_.rows(), embedded_.cols());
  encoder_->lstm_.backward(parameters, packing_, embedded_, lstm_, dembedded_);
  if (embedded_mask_.size() > 0) dembedded_.array() *= embedded_mask_.array();
  auto gradient = parameters.gradient(encoder_->words_);
  for (Index c = 0; c < dembedded_.cols(); ++c)
    gradient.col(words_[static_cast<std::size_t>(c)].index) += dembedded_.col(c);
}

}  // namespace waymark::parser
