// Scores of an encoder-decoder for one sentence: log p of every symbol that may follow, for a batch of prefixes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "libparser/model/encoder_decoder.hpp"

namespace waymark::parser {

// What may follow a prefix.
struct ChoiceMask {
  std::vector<Symbol> allowed;   // ascending
  std::optional<Symbol> forced;  // the only one, when there is just one
};

// Masks of the states that were asked for, made once each. References stay valid as long as the object.
class ChoiceMasks {
 public:
  explicit ChoiceMasks(const TypedPostfix& symbols) : symbols_(&symbols) {}
  const TypedPostfix& symbols() const { return *symbols_; }  // of the network
  const ChoiceMask& of(const TypedState& state);             // of a state of the grammar; made when first asked for
  std::size_t size() const { return made_.size(); }

 private:
  const TypedPostfix* symbols_;
  std::unordered_map<std::uint64_t, ChoiceMask> made_;  // by the state
};

// log p of the allowed symbols, from a column of scores; other entries are left alone. log_p: [symbols]
void log_softmax(const neural::ConstView& scores, neural::Index column, const ChoiceMask& mask,
                 const std::vector<bool>& forbidden, float* log_p);

// A prefix of a program, as the network sees it.
struct NetworkPrefix {
  TypedState state;                                  // of the grammar
  History history;                                   // the last symbols
  const ChoiceMask* mask;                            // of the symbols that may follow
  bool ended() const { return state.prefix.ended; }  // is the program complete?
};

// Prefixes of the network: what follows them of necessity is taken with each symbol. Network and masks must outlive it.
class NetworkPrefixes {
 public:
  using Prefix = NetworkPrefix;
  NetworkPrefixes(const EncoderDecoder& network, ChoiceMasks& masks) : network_(&network), masks_(&masks) {}
  Prefix first() const { return {{}, network_->first_history(), &masks_->of({})}; }  // the empty one
  // Appends the symbols that were taken.
  Prefix after(const Prefix& prefix, Symbol symbol, std::vector<Symbol>& taken) const;
  std::vector<Symbol> tokens_of(const Program& program) const { return masks_->symbols().symbols_of(program); }
  Program program_of(std::span<const Symbol> symbols) const { return masks_->symbols().program_of(symbols); }

 private:
  const EncoderDecoder* network_;
  ChoiceMasks* masks_;
};

class NetworkScorer {
 public:
  using Prefix = NetworkPrefix;
  // A product of matrices costs little more for sixteen columns than for one.
  static constexpr std::size_t at_once = 16;
  // Network, sentence and masks must outlive it. Masks that are there already make no difference but for time.
  NetworkScorer(const EncoderDecoder& network, const NetworkSentence& sentence, ChoiceMasks& masks);

  NetworkPrefixes prefixes() const { return {*network_, *masks_}; }  // with the masks of this scorer
  // visit(i, symbol, log p(symbol | batch[i], sentence)) for every symbol that may follow.
  template <class Visit>
  void log_p(std::span<const Prefix* const> batch, const Visit& visit) {
    const neural::Matrix& scores = decode(batch);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const ChoiceMask& mask = *batch[i]->mask;
      log_softmax(scores, static_cast<neural::Index>(i), mask, sentence_->forbidden, log_p_.data());
      for (const Symbol v : mask.allowed) visit(i, v, log_p_[v]);
    }
  }

 private:
  const neural::Matrix& decode(std::span<const Prefix* const> batch);

  const EncoderDecoder* network_;
  const NetworkSentence* sentence_;
  ChoiceMasks* masks_;
  EncoderDecoder::Pass pass_;
  std::vector<History> histories_;
  std::vector<float> log_p_;
};

}  // namespace waymark::parser
