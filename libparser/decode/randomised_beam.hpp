// The randomised beam of training: programs of several sentences at once under an encoder-decoder.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libparser/decode/best_first.hpp"

namespace waymark::parser {

// For each of the sentences that `pass` has encoded: the programs of a beam of `beam` prefixes that grow symbol by
// symbol; each place of the beam is taken by the best continuation that is left or, with probability epsilon, by any of
// them, all equally likely. epsilon = 0 is ordinary beam search. Source: [GPLL17, Sec. 4.1].
std::vector<std::vector<Candidate>> randomised_beam(const EncoderDecoder& network, EncoderDecoder::Pass& pass,
                                                    std::span<const NetworkSentence* const> sentences,
                                                    ChoiceMasks& masks, std::size_t beam, double epsilon,
                                                    ltl::Random& random);

}  // namespace waymark::parser
