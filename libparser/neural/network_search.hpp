// Programs of a sentence under an encoder-decoder: the likeliest ones, exactly, and a randomised beam.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "libltl/random.hpp"
#include "libparser/neural/encoder_decoder.hpp"
#include "libparser/neural/symbol_trie.hpp"
#include "libparser/reader.hpp"

namespace waymark::parser {

// As best_programs of beam.hpp: prefixes by probability, a few expanded at a time because a product of matrices costs
// little more for sixteen columns than for one. A program is given when no open prefix is likelier: the order is exact.
std::vector<Candidate> best_programs(const EncoderDecoder& network, const NetworkSentence& sentence,
                                     std::size_t beam, std::size_t expansions = 2000);

// For each of the sentences that `pass` has encoded: the programs of a beam of `beam` prefixes that grow symbol by symbol; each
// place of the beam is taken by the best continuation that is left or, with probability epsilon, by any of them, all equally
// likely. epsilon = 0 is ordinary beam search. Source: [GPLL17, Sec. 4.1].
std::vector<std::vector<Candidate>> randomised_beam(const EncoderDecoder& network, EncoderDecoder::Pass& pass,
                                                    std::span<const NetworkSentence* const> sentences,
                                                    ChoiceMasks& masks, std::size_t beam, double epsilon,
                                                    ltl::Random& random);

class NetworkReader : public Reader {
 public:
  explicit NetworkReader(EncoderDecoder network) : network_(std::move(network)) {}
  const EncoderDecoder& network() const { return network_; }
  std::vector<Candidate> read(const SentenceInput& input, std::size_t beam) const override {
    return best_programs(network_, network_.sentence(input), beam);
  }

 private:
  EncoderDecoder network_;
};

}  // namespace waymark::parser
