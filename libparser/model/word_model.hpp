// A word model is log p(next token | prefix, sentence) for a batch of prefixes, and nothing else.
//
//   prefixes   the empty prefix, prefixes one token longer, and the program of a complete prefix. A prefix holds the
//              state of the model after it. Tokens that the grammar forces are taken with the token before them
//   scorer     the probabilities of one sentence
// decode/ finds the likeliest programs and holds many programs at once, for every model alike.
#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "libparser/model/linear_model.hpp"
#include "libparser/model/network_model.hpp"
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

// A type of word models: its place in a file, which `file_kind` announces, and its scorer of one sentence, which
// with_scorer gives to `use` and takes back afterwards.
struct AnyUse {
  bool operator()(WordScorer auto&) const { return true; }
};
template <class M>
concept ReadsSentences = requires(const M& model, const SentenceInput& input, WeightsReader& in,
                                  const RankingModel& ranking, WeightsWriter& out, double threshold) {
  { M::file_kind } -> std::convertible_to<std::uint16_t>;  // from 1, none twice
  { M::read(in, ranking) } -> std::same_as<std::shared_ptr<const M>>;
  model.write(out, threshold);  // without the weights below the threshold
  { with_scorer(model, input, AnyUse()) } -> std::same_as<bool>;
};

// One of these models, shared.
template <ReadsSentences... Models>
using OneOf = std::variant<std::shared_ptr<const Models>...>;
using WordModel = OneOf<LinearModel, NetworkModel>;  // every word model

}  // namespace waymark::parser
