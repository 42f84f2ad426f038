#include "libparser/lifted/lifted_network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libparser/corpus/token.hpp"

namespace waymark::parser {

using neural::Index;
using neural::Matrix;

namespace {

constexpr auto symbols = static_cast<Index>(lifted_symbols);

void drop(Matrix& signals, Matrix& mask, const Dropout& dropout) {
  mask.resize(0, 0);
  if (dropout.signals <= 0) return;
  const auto kept = static_cast<float>(1 / (1 - dropout.signals));
  mask.resize(signals.rows(), signals.cols());
  for (Index i = 0; i < mask.size(); ++i) mask.data()[i] = dropout.uniform() < dropout.signals ? 0.0F : kept;
  signals.array() *= mask.array();
}

neural::AttentionDecoder::Sizes decoder_sizes(const LiftedSizes& s, Index inputs) {
  return {.encoded = Index{2} * s.width, .inputs = inputs, .width = s.query, .symbol = s.symbol, .symbols = symbols};
}

}  // namespace

LiftedText mirrored(LiftedText text) {
  text.tokens = mirror(std::move(text.tokens));
  return text;
}

bool is_read_in_mirror(const LiftedText& text) {
  if (!text.scope.spatial) return false;
  for (const std::string& token : text.tokens)
    if (const auto side = side_of(token)) return side == Side::Right;
  return false;
}

LiftedNetwork::LiftedNetwork(WordTable words, std::shared_ptr<const WordVectors> vectors, const LiftedSizes& sizes,
                             const neural::Uniform& uniform)
    : words_(std::move(words)),
      vectors_(std::move(vectors)),
      sizes_(sizes),
      embeddings_(parameters_.add_for_relu(sizes.word, static_cast<Index>(words_.words().size()), 60, uniform)),
      projection_(
          parameters_.add_for_relu(sizes.vector, WordVectors::dimensions, 4 * WordVectors::dimensions, uniform)),
      phi_(parameters_.add_for_relu(sizes.symbol, symbols + 1, 60, uniform)),
      lstm_(parameters_, sizes.word + sizes.vector, sizes.width, uniform),
      decoder_(parameters_, decoder_sizes(sizes, inputs()), phi_, uniform) {}

LiftedNetwork::Sentence LiftedNetwork::sentence(const LiftedText& text) const {
  Sentence out;
  const auto none = static_cast<std::uint32_t>(vectors_->size());
  out.words.push_back(words_.find("<" + text.domain + ">"));
  out.vectors.push_back(none);
  for (const std::string& token : text.tokens) {
    out.words.push_back(words_.find(token));
    const bool is_side = text.scope.spatial && side_of(token);  // the vectors of left and right are much alike
    out.vectors.push_back(is_side ? none : static_cast<std::uint32_t>(vectors_->find(token).value_or(none)));
  }
  return out;
}

LiftedNetwork::Prefix LiftedNetwork::Prefix::after(LiftedSymbol s) const {
  Prefix next = *this;
  next.grammar.append(s);
  std::copy_backward(next.last.begin(), next.last.end() - 1, next.last.end());
  next.last.front() = s;
  return next;
}

void LiftedNetwork::Pass::place(std::span<const Sentence* const> sentences, const Dropout& dropout) {
  order_.resize(sentences.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return sentences[a]->words.size() > sentences[b]->words.size();
  });
  std::vector<Index> lengths, rank(sentences.size());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    lengths.push_back(static_cast<Index>(sentences[order_[i]]->words.size()));
    rank[order_[i]] = static_cast<Index>(i);
  }
  packing_ = neural::Packing(lengths);
  words_.resize(static_cast<std::size_t>(packing_.columns()));
  vectors_.resize(words_.size());
  column_.clear();
  h_begin_ = {0};
  const bool draws = dropout.words > 0;
  for (std::size_t s = 0; s < sentences.size(); ++s) {
    for (std::size_t t = 0; t < sentences[s]->words.size(); ++t) {
      const Index c = packing_.column(rank[s], static_cast<Index>(t));
      column_.push_back(c);
      const auto at = static_cast<std::size_t>(c);
      words_[at] = sentences[s]->words[t];
      vectors_[at] = sentences[s]->vectors[t];
      // A word that has a vector may be read by its vector alone, as unknown words are.
      const bool has_vector = vectors_[at] < network_->vectors_->size();
      if (draws && (has_vector || t == 0) && dropout.uniform() < dropout.words) words_[at] = WordTable::unknown;
    }
    h_begin_.push_back(static_cast<Index>(column_.size()));
  }
}

void LiftedNetwork::Pass::embed() {
  const auto table = parameters_->value(network_->embeddings_);
  const WordVectors& known = *network_->vectors_;
  fixed_.setZero(static_cast<Index>(WordVectors::dimensions), packing_.columns());
  input_.setZero(network_->sizes_.word + network_->sizes_.vector, packing_.columns());
  for (Index c = 0; c < packing_.columns(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    input_.col(c).head(table.rows()) = table.col(words_[at].index);
    if (vectors_[at] >= known.size()) continue;
    const auto entries = known.entries(vectors_[at]);
    const float scale = known.scale(vectors_[at]);
    for (std::size_t i = 0; i < entries.size(); ++i)
      fixed_(static_cast<Index>(i), c) = scale * static_cast<float>(entries[i]);
  }
  neural::add_product(parameters_->value(network_->projection_), fixed_, input_.bottomRows(network_->sizes_.vector));
}

void LiftedNetwork::Pass::encode(const LiftedNetwork& network, const neural::Parameters& parameters,
                                 std::span<const Sentence* const> sentences, const Dropout& dropout) {
  network_ = &network;
  parameters_ = &parameters;
  is_attended_ = false;
  place(sentences, dropout);
  embed();
  drop(input_, input_mask_, dropout);
  network.lstm_.forward(parameters, packing_, input_, lstm_);
  h_.resize(network.lstm_.width(), packing_.columns());
  for (Index c = 0; c < packing_.columns(); ++c) h_.col(c) = lstm_.h.col(column_[static_cast<std::size_t>(c)]);
  drop(h_, h_mask_, dropout);
  e_.resize(h_.rows(), static_cast<Index>(sentences.size()));
  for (std::size_t i = 0; i < order_.size(); ++i)
    e_.col(static_cast<Index>(order_[i])) = lstm_.last.col(static_cast<Index>(i));
}

namespace {

// The symbols whose embeddings a prefix shows, the latest first, then the open operators; `symbols`: none.
std::array<Index, LiftedNetwork::remembered + 2> shown(const LiftedNetwork::Prefix& prefix) {
  std::array<Index, LiftedNetwork::remembered + 2> out;
  out.fill(symbols);
  for (std::size_t k = 0; k < std::min(LiftedNetwork::remembered, prefix.grammar.length()); ++k)
    out[k] = static_cast<Index>(prefix.last[k]);
  const auto open = prefix.grammar.open();
  for (std::size_t k = 0; k < std::min<std::size_t>(2, open.size()); ++k)
    out[LiftedNetwork::remembered + k] = static_cast<Index>(open[open.size() - 1 - k].symbol);
  return out;
}

}  // namespace

const Matrix& LiftedNetwork::Pass::decode(std::span<const Index> begin, std::span<const Prefix> prefixes) {
  begin_.assign(begin.begin(), begin.end());
  prefixes_.assign(prefixes.begin(), prefixes.end());
  said_.resize(prefixes.size());
  std::iota(said_.begin(), said_.end(), Index{0});
  const Index size = network_->sizes_.symbol;
  const auto phi = parameters_->value(network_->phi_);
  x_.setZero(network_->inputs(), static_cast<Index>(prefixes.size()));
  for (Index c = 0; c < x_.cols(); ++c) {
    const Prefix& prefix = prefixes_[static_cast<std::size_t>(c)];
    const auto seen = shown(prefix);
    for (std::size_t k = 0; k < seen.size(); ++k)
      x_.col(c).segment(static_cast<Index>(k) * size, size) = phi.col(seen[k]);
    const Index at = static_cast<Index>(seen.size()) * size;
    if (!prefix.grammar.open().empty()) x_(at + std::min<Index>(prefix.grammar.open().back().operands, 7), c) = 1;
    for (Index s = 0; s < 12; ++s)
      if ((prefix.grammar.slots_used() >> s & 1U) != 0) x_(at + 8 + s, c) = 1;
  }
  network_->decoder_.forward(*parameters_, sequences(), x_, decoder_);
  is_attended_ = true;
  return decoder_.scores;
}

void LiftedNetwork::Pass::backward(neural::Parameters& parameters, const Matrix& dscores) {
  decoder_.dscores = dscores;
  dx_.resize(x_.rows(), x_.cols());
  network_->decoder_.backward(parameters, sequences(), x_, decoder_, dx_);
  const Index size = network_->sizes_.symbol;
  auto dphi = parameters.gradient(network_->phi_);
  for (Index c = 0; c < dx_.cols(); ++c) {
    const auto seen = shown(prefixes_[static_cast<std::size_t>(c)]);
    for (std::size_t k = 0; k < seen.size(); ++k)
      dphi.col(seen[k]) += dx_.col(c).segment(static_cast<Index>(k) * size, size);
  }
  Matrix& dh = decoder_.dh;
  if (h_mask_.size() > 0) dh.array() *= h_mask_.array();
  lstm_.dh.resize(h_.rows(), h_.cols());
  for (Index c = 0; c < h_.cols(); ++c) lstm_.dh.col(column_[static_cast<std::size_t>(c)]) = dh.col(c);
  lstm_.dlast.resize(e_.rows(), e_.cols());
  for (std::size_t i = 0; i < order_.size(); ++i)
    lstm_.dlast.col(static_cast<Index>(i)) = decoder_.de.col(static_cast<Index>(order_[i]));
  dinput_.resize(input_.rows(), input_.cols());
  network_->lstm_.backward(parameters, packing_, input_, lstm_, dinput_);
  if (input_mask_.size() > 0) dinput_.array() *= input_mask_.array();
  auto gradient = parameters.gradient(network_->embeddings_);
  for (Index c = 0; c < dinput_.cols(); ++c)
    gradient.col(words_[static_cast<std::size_t>(c)].index) += dinput_.col(c).head(gradient.rows());
  neural::add_product_transposed(dinput_.bottomRows(network_->sizes_.vector), fixed_,
                                 parameters.gradient(network_->projection_));
}

void log_softmax(const neural::ConstView& scores, Index column, const LiftedPrefix& prefix, const LiftedScope& scope,
                 std::span<float> log_p) {
  float highest = -INFINITY, total = 0;
  for (std::size_t v = 0; v < lifted_symbols; ++v) {
    log_p[v] = prefix.allows(static_cast<LiftedSymbol>(v), scope) ? scores(static_cast<Index>(v), column) : -INFINITY;
    highest = std::max(highest, log_p[v]);
  }
  for (const float p : log_p) total += std::exp(p - highest);
  const float logarithm = highest + std::log(total);
  for (float& p : log_p) p -= logarithm;
}

std::vector<double> score_lifted(const LiftedNetwork& network, const LiftedText& text,
                                 std::span<const Lifted> formulas) {
  std::vector<double> out;
  if (formulas.empty()) return out;
  const LiftedNetwork::Sentence sentence = network.sentence(text);
  const LiftedNetwork::Sentence* const one = &sentence;
  LiftedNetwork::Pass pass;
  pass.encode(network, network.parameters(), {&one, 1});
  std::vector<LiftedNetwork::Prefix> prefixes;
  for (const Lifted& formula : formulas) {
    LiftedNetwork::Prefix prefix;
    for (const LiftedSymbol s : formula) {
      prefixes.push_back(prefix);
      if (!prefix.grammar.allows(s, text.scope)) break;
      prefix = prefix.after(s);
    }
  }
  const Index begin[] = {0, static_cast<Index>(prefixes.size())};
  const Matrix& scores = pass.decode(begin, prefixes);
  std::array<float, lifted_symbols> log_p;
  Index column = 0;
  for (const Lifted& formula : formulas) {
    out.push_back(0);
    for (const LiftedSymbol s : formula) {
      const LiftedPrefix& prefix = prefixes[static_cast<std::size_t>(column)].grammar;
      log_softmax(scores, column++, prefix, text.scope, log_p);
      out.back() += static_cast<double>(log_p[static_cast<std::size_t>(s)]);
      if (!prefix.allows(s, text.scope)) break;
    }
  }
  return out;
}

std::vector<LiftedReading> read_lifted(const LiftedNetwork& network, const LiftedText& text, std::size_t beam) {
  struct Open {
    LiftedNetwork::Prefix prefix;
    Lifted lifted;
    double log_p = 0;
  };
  const LiftedNetwork::Sentence sentence = network.sentence(text);
  const LiftedNetwork::Sentence* const one = &sentence;
  LiftedNetwork::Pass pass;
  pass.encode(network, network.parameters(), {&one, 1});
  std::vector<Open> open(1);
  std::vector<LiftedReading> found;
  std::array<float, lifted_symbols> log_p;
  while (!open.empty()) {
    std::vector<LiftedNetwork::Prefix> prefixes;
    for (const Open& o : open) prefixes.push_back(o.prefix);
    const Index begin[] = {0, static_cast<Index>(open.size())};
    const Matrix& scores = pass.decode(begin, prefixes);
    struct Next {
      std::size_t parent;
      LiftedSymbol symbol;
      double log_p;
    };
    std::vector<Next> next;
    for (std::size_t i = 0; i < open.size(); ++i) {
      log_softmax(scores, static_cast<Index>(i), open[i].prefix.grammar, text.scope, log_p);
      for (std::size_t v = 0; v < lifted_symbols; ++v)
        if (const double sum = open[i].log_p + log_p[v]; sum > -14)
          next.push_back({i, static_cast<LiftedSymbol>(v), sum});
    }
    std::stable_sort(next.begin(), next.end(), [](const Next& a, const Next& b) { return a.log_p > b.log_p; });
    if (next.size() > beam) next.resize(beam);
    std::vector<Open> longer;
    for (const Next& n : next) {
      Open o{open[n.parent].prefix.after(n.symbol), open[n.parent].lifted, n.log_p};
      o.lifted.push_back(n.symbol);
      if (o.prefix.grammar.ended())
        found.push_back({std::move(o.lifted), o.log_p});
      else
        longer.push_back(std::move(o));
    }
    open = std::move(longer);
    std::stable_sort(found.begin(), found.end(), [](const LiftedReading& a, const LiftedReading& b) {
      return a.log_probability > b.log_probability;
    });
    if (found.size() > beam) found.resize(beam);
    if (found.size() == beam && (open.empty() || open.front().log_p < found.back().log_probability)) break;
  }
  return found;
}

}  // namespace waymark::parser
