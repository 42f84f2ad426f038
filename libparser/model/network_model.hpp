// An encoder-decoder as a word model. The masks of its symbols are shared by all who read with it.
#pragma once
#include <cstdint>
#include <memory>
#include <utility>

#include "libparser/model/mask_pool.hpp"
#include "libparser/model/network_scorer.hpp"

namespace waymark::parser {

struct RankingModel;
class WeightsReader;
class WeightsWriter;

struct NetworkModel {
  static constexpr std::uint16_t file_kind = 2;  // in the header of a model file
  explicit NetworkModel(EncoderDecoder learned) : network(std::move(learned)), masks(network.symbols()) {}
  NetworkModel(const NetworkModel&) = delete;
  NetworkModel& operator=(const NetworkModel&) = delete;
  // Throws ltl::FormatError.
  static std::shared_ptr<const NetworkModel> read(WeightsReader& in, const RankingModel& ranking);
  void write(WeightsWriter& out, double threshold) const;  // all weights, whatever the threshold

  EncoderDecoder network;  // that reads
  mutable MaskPool masks;  // shared, and locked
};

// Calls use(scorer) with the masks of the model.
template <class Use>
auto with_scorer(const NetworkModel& model, const SentenceInput& input, const Use& use) {
  return model.masks.lend([&](ChoiceMasks& masks) {
    const NetworkSentence sentence = model.network.sentence(input);
    NetworkScorer scorer(model.network, sentence, masks);
    return use(scorer);
  });
}

}  // namespace waymark::parser
