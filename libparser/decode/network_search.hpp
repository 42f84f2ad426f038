// Programs of a sentence under an encoder-decoder: the likeliest ones, exactly, and a randomised beam.
#pragma once
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libparser/decode/reader.hpp"
#include "libparser/decode/symbol_trie.hpp"
#include "libparser/model/encoder_decoder.hpp"

namespace waymark::parser {

// As best_programs of beam.hpp: prefixes by probability, a few expanded at a time because a product of matrices costs
// little more for sixteen columns than for one. A program is given when no open prefix is likelier: the order is exact.
// masks: of the network's symbols; what it holds already makes no difference but for time.
std::vector<Candidate> best_programs(const EncoderDecoder& network, const NetworkSentence& sentence,
                                     ChoiceMasks& masks, std::size_t beam, std::size_t expansions = 2000);

// For each of the sentences that `pass` has encoded: the programs of a beam of `beam` prefixes that grow symbol by symbol; each
// place of the beam is taken by the best continuation that is left or, with probability epsilon, by any of them, all equally
// likely. epsilon = 0 is ordinary beam search. Source: [GPLL17, Sec. 4.1].
std::vector<std::vector<Candidate>> randomised_beam(const EncoderDecoder& network, EncoderDecoder::Pass& pass,
                                                    std::span<const NetworkSentence* const> sentences,
                                                    ChoiceMasks& masks, std::size_t beam, double epsilon,
                                                    ltl::Random& random);

class NetworkReader : public Reader {  // may read in several threads at once
 public:
  explicit NetworkReader(EncoderDecoder network) : network_(std::move(network)) {}
  const EncoderDecoder& network() const { return network_; }
  std::vector<Candidate> read(const SentenceInput& input, std::size_t beam) const override;

 private:
  static constexpr std::size_t most_masks = 20'000;  // kept by each; some 500 bytes a mask

  EncoderDecoder network_;
  mutable std::mutex mutex_;
  mutable std::vector<ChoiceMasks> masks_;  // that no thread reads with right now
};

}  // namespace waymark::parser
