#include "libparser/decode/randomised_beam.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace waymark::parser {
namespace {

constexpr std::size_t most_symbols = 128;  // of a program; the grammar allows fewer

struct Prefix {
  NetworkPrefix prefix;
  std::vector<Symbol> symbols;
  float log_probability;
};

struct Continuation {
  std::size_t prefix;
  Symbol symbol;
  float sum;  // log p of the prefix with the symbol
};

// Takes up to `beam` of the continuations, in the order of their places.
std::vector<Continuation> drawn(std::vector<Continuation> all, std::size_t beam, double epsilon, ltl::Random& random) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.sum > b.sum; });
  std::vector<Continuation> out;
  while (!all.empty() && out.size() < beam) {
    const std::size_t i = epsilon > 0 && random.chance(epsilon) ? random.below(all.size()) : 0;
    out.push_back(all[i]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return out;
}

}  // namespace

std::vector<std::vector<Candidate>> randomised_beam(const EncoderDecoder& network, EncoderDecoder::Pass& pass,
                                                    std::span<const NetworkSentence* const> sentences,
                                                    ChoiceMasks& masks, std::size_t beam, double epsilon,
                                                    ltl::Random& random) {
  std::vector<std::vector<Candidate>> found(sentences.size());
  const NetworkPrefixes prefixes(network, masks);
  std::vector<std::vector<Prefix>> beams(sentences.size(), {Prefix{prefixes.first(), {}, 0.0F}});
  std::vector<float> log_p(network.symbols().symbols());
  std::vector<neural::Index> begin(sentences.size() + 1);
  for (std::size_t length = 0; length < most_symbols; ++length) {
    std::vector<History> histories;
    for (std::size_t s = 0; s < sentences.size(); ++s) {
      for (const Prefix& prefix : beams[s]) histories.push_back(prefix.prefix.history);
      begin[s + 1] = static_cast<neural::Index>(histories.size());
    }
    if (histories.empty()) break;
    const neural::Matrix& scores = pass.decode(begin, histories);
    for (std::size_t s = 0; s < sentences.size(); ++s) {
      std::vector<Continuation> all;
      for (std::size_t i = 0; i < beams[s].size(); ++i) {
        const Prefix& prefix = beams[s][i];
        const ChoiceMask& mask = *prefix.prefix.mask;
        log_softmax(scores, begin[s] + static_cast<neural::Index>(i), mask, sentences[s]->forbidden, log_p.data());
        for (const Symbol v : mask.allowed)
          if (log_p[v] > -INFINITY) all.push_back({i, v, prefix.log_probability + log_p[v]});
      }
      std::vector<Prefix> next;
      for (const Continuation& c : drawn(std::move(all), beam - std::min(beam, found[s].size()), epsilon, random)) {
        Prefix longer{{}, beams[s][c.prefix].symbols, c.sum};
        longer.prefix = prefixes.after(beams[s][c.prefix].prefix, c.symbol, longer.symbols);
        if (longer.prefix.ended())
          found[s].push_back({prefixes.program_of(longer.symbols), longer.log_probability});
        else
          next.push_back(std::move(longer));
      }
      beams[s] = std::move(next);
    }
  }
  for (auto& candidates : found)
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.log_probability > b.log_probability; });
  return found;
}

}  // namespace waymark::parser
