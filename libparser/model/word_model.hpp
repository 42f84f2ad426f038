// A word model is log p(next token | prefix, sentence) for a batch of prefixes, and nothing else.
//
//   prefixes   the empty prefix, prefixes one token longer, and the program of a complete prefix. A prefix holds the
//              state of the model after it. Tokens that the grammar forces are taken with the token before them
//   scorer     the probabilities of one sentence
// decode/ finds the likeliest programs and holds many programs at once, for every model alike.
#pragma once
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "libparser/model/linear_model.hpp"
#include "libparser/model/mask_pool.hpp"
#include "libparser/model/network_scorer.hpp"
#include "libparser/model/scorer.hpp"

namespace waymark::parser {

template <class P>
concept PrefixesOfPrograms = requires(const P& prefixes, const typename P::Prefix& prefix, Token token,
                                      std::vector<Token>& taken, const Program& program) {
  { prefixes.first() } -> std::same_as<typename P::Prefix>;
  { prefixes.after(prefix, token, taken) } -> std::same_as<typename P::Prefix>;  // appends what was taken
  { prefix.ended() } -> std::same_as<bool>;
  { prefixes.tokens_of(program) } -> std::same_as<std::vector<Token>>;
  { prefixes.program_of(taken) } -> std::same_as<Program>;
};

template <class S>
concept WordScorer = requires(S& scorer, std::span<const typename S::Prefix* const> batch,
                              void (*visit)(std::size_t i, Token token, float log_p)) {
  { scorer.prefixes() } -> PrefixesOfPrograms;
  { S::at_once } -> std::convertible_to<std::size_t>;  // how large a batch costs little more than one prefix
  scorer.log_p(batch, visit);                          // calls it for every token that may follow batch[i]
};

// Masks of the network's symbols are shared by all who read with it.
struct NetworkModel {
  explicit NetworkModel(EncoderDecoder learned) : network(std::move(learned)), masks(network.symbols()) {}
  NetworkModel(const NetworkModel&) = delete;
  NetworkModel& operator=(const NetworkModel&) = delete;

  EncoderDecoder network;
  mutable MaskPool masks;
};

using WordModel = std::variant<std::shared_ptr<const LinearModel>, std::shared_ptr<const NetworkModel>>;

}  // namespace waymark::parser
