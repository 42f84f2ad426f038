#include "libparser/decode/network_search.hpp"

#include <algorithm>
#include <queue>

namespace waymark::parser {
namespace {

constexpr float least = -12.0F;  // log-probability below which a prefix is not worth keeping, as in beam.cpp
constexpr std::size_t at_once = 16;
constexpr std::size_t most_symbols = 128;  // of a program; the grammar allows fewer

struct Prefix {
  TypedState state;
  std::vector<Symbol> symbols;
  History history;
  float log_probability = 0;
};

// The prefix with one more symbol, and those that the grammar forces then.
Prefix extended(const Prefix& prefix, Symbol symbol, float log_p, ChoiceMasks& masks) {
  Prefix next = prefix;
  next.log_probability += log_p;
  for (std::optional<Symbol> forced = symbol; forced; forced = masks.of(next.state).forced) {
    next.state = masks.symbols().after(next.state, *forced);
    next.symbols.push_back(*forced);
    EncoderDecoder::remember(next.history, *forced);
  }
  return next;
}

struct Open {
  float log_probability;
  std::size_t prefix;
  friend bool operator<(const Open& a, const Open& b) {
    return a.log_probability != b.log_probability ? a.log_probability < b.log_probability
                                                  : a.prefix > b.prefix;
  }
};

}  // namespace

std::vector<Candidate> best_programs(const EncoderDecoder& network, const NetworkSentence& sentence,
                                     ChoiceMasks& masks, std::size_t beam, std::size_t expansions) {
  const TypedPostfix& symbols = network.symbols();
  EncoderDecoder::Pass pass;
  const NetworkSentence* const only = &sentence;
  pass.encode(network, network.parameters(), {&only, 1});
  std::vector<Prefix> prefixes{{{}, {}, network.first_history(), 0.0F}};
  std::priority_queue<Open> open;
  open.push({0, 0});
  std::vector<Candidate> found;
  std::vector<std::size_t> batch;
  std::vector<History> histories;
  std::vector<float> log_p(symbols.symbols());
  while (!open.empty() && found.size() < beam) {
    batch.clear();
    histories.clear();
    std::vector<Open> ended;  // behind prefixes that are not expanded yet
    while (!open.empty() && batch.size() < at_once && ended.size() < at_once) {
      const Open top = open.top();
      open.pop();
      const Prefix& prefix = prefixes[top.prefix];
      if (!prefix.state.prefix.ended) {
        batch.push_back(top.prefix);
        histories.push_back(prefix.history);
      } else if (batch.empty()) {
        found.push_back({symbols.program_of(prefix.symbols), top.log_probability});
        if (found.size() == beam) return found;
      } else {
        ended.push_back(top);
      }
    }
    for (const Open& later : ended) open.push(later);
    if (batch.empty() || expansions < batch.size()) break;
    expansions -= batch.size();
    const neural::Index begin[] = {0, static_cast<neural::Index>(batch.size())};
    const neural::Matrix& scores = pass.decode(begin, histories);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const ChoiceMask& mask = masks.of(prefixes[batch[i]].state);
      log_softmax(scores, static_cast<neural::Index>(i), mask, sentence.forbidden, log_p.data());
      for (const Symbol v : mask.allowed) {
        if (!(prefixes[batch[i]].log_probability + log_p[v] > least)) continue;
        prefixes.push_back(extended(prefixes[batch[i]], v, log_p[v], masks));
        open.push({prefixes.back().log_probability, prefixes.size() - 1});
      }
    }
  }
  return found;
}

namespace {

struct Continuation {
  std::size_t prefix;
  Symbol symbol;
  float log_p, sum;
};

// Takes up to `beam` of the continuations, in the order of their places.
std::vector<Continuation> drawn(std::vector<Continuation> all, std::size_t beam, double epsilon,
                                ltl::Random& random) {
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
  std::vector<std::vector<Prefix>> beams(sentences.size(), {Prefix{{}, {}, network.first_history(), 0.0F}});
  std::vector<float> log_p(network.symbols().symbols());
  std::vector<neural::Index> begin(sentences.size() + 1);
  for (std::size_t length = 0; length < most_symbols; ++length) {
    std::vector<History> histories;
    for (std::size_t s = 0; s < sentences.size(); ++s) {
      for (const Prefix& prefix : beams[s]) histories.push_back(prefix.history);
      begin[s + 1] = static_cast<neural::Index>(histories.size());
    }
    if (histories.empty()) break;
    const neural::Matrix& scores = pass.decode(begin, histories);
    for (std::size_t s = 0; s < sentences.size(); ++s) {
      std::vector<Continuation> all;
      for (std::size_t i = 0; i < beams[s].size(); ++i) {
        const Prefix& prefix = beams[s][i];
        const ChoiceMask& mask = masks.of(prefix.state);
        log_softmax(scores, begin[s] + static_cast<neural::Index>(i), mask, sentences[s]->forbidden,
                    log_p.data());
        for (const Symbol v : mask.allowed)
          if (log_p[v] > -INFINITY) all.push_back({i, v, log_p[v], prefix.log_probability + log_p[v]});
      }
      std::vector<Prefix> next;
      for (const Continuation& c :
           drawn(std::move(all), beam - std::min(beam, found[s].size()), epsilon, random)) {
        Prefix longer = extended(beams[s][c.prefix], c.symbol, c.log_p, masks);
        if (longer.state.prefix.ended)
          found[s].push_back({network.symbols().program_of(longer.symbols), longer.log_probability});
        else
          next.push_back(std::move(longer));
      }
      beams[s] = std::move(next);
    }
  }
  for (auto& candidates : found)
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.log_probability > b.log_probability;
    });
  return found;
}

std::vector<Candidate> NetworkReader::read(const SentenceInput& input, std::size_t beam) const {
  const auto taken = [&] {
    const std::lock_guard lock(mutex_);
    if (masks_.empty()) return ChoiceMasks(network_.symbols());
    ChoiceMasks last = std::move(masks_.back());
    masks_.pop_back();
    return last;
  };
  ChoiceMasks masks = taken();
  std::vector<Candidate> found = best_programs(network_, network_.sentence(input), masks, beam);
  if (masks.size() <= most_masks) {
    const std::lock_guard lock(mutex_);
    masks_.push_back(std::move(masks));
  }
  return found;
}

}  // namespace waymark::parser
