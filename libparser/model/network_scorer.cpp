#include "libparser/model/network_scorer.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::parser {

const ChoiceMask& ChoiceMasks::of(const TypedState& state) {
  const PrefixState& p = state.prefix;
  const std::uint64_t key =
      std::uint64_t{state.thing} << 48U | std::uint64_t{p.last_literal} << 32U | std::uint64_t{p.steps} << 24U |
      std::uint64_t{p.goals} << 16U | std::uint64_t{p.bools} << 12U | std::uint64_t{p.step_entries} << 8U |
      std::uint64_t{p.awaits} << 5U | std::uint64_t{p.operand} << 4U | std::uint64_t{p.turns} << 3U |
      std::uint64_t{p.oriented} << 2U | std::uint64_t{p.stayed} << 1U | std::uint64_t{p.ended};
  const auto [it, is_new] = made_.try_emplace(key);
  if (is_new) {
    const std::vector<bool> allowed = symbols_->allowed(state);
    for (Symbol v = 0; v < allowed.size(); ++v)
      if (allowed[v]) it->second.allowed.push_back(v);
    it->second.forced = symbols_->forced(state);
  }
  return it->second;
}

void log_softmax(const neural::ConstView& scores, neural::Index column, const ChoiceMask& mask,
                 const std::vector<bool>& forbidden, float* log_p) {
  float highest = -INFINITY, total = 0;
  for (const Symbol v : mask.allowed) {
    log_p[v] = forbidden[v] ? -INFINITY : scores(v, column);
    highest = std::max(highest, log_p[v]);
  }
  for (const Symbol v : mask.allowed) total += std::exp(log_p[v] - highest);
  const float logarithm = highest + std::log(total);
  for (const Symbol v : mask.allowed) log_p[v] -= logarithm;
}

NetworkPrefix NetworkPrefixes::after(const Prefix& prefix, Symbol symbol, std::vector<Symbol>& taken) const {
  Prefix next = prefix;
  for (std::optional<Symbol> more = symbol; more; more = next.mask->forced) {
    next.state = masks_->symbols().after(next.state, *more);
    next.mask = &masks_->of(next.state);
    EncoderDecoder::remember(next.history, *more);
    taken.push_back(*more);
  }
  return next;
}

NetworkScorer::NetworkScorer(const EncoderDecoder& network, const NetworkSentence& sentence, ChoiceMasks& masks)
    : network_(&network), sentence_(&sentence), masks_(&masks), log_p_(network.symbols().symbols()) {
  pass_.encode(network, network.parameters(), {&sentence_, 1});
}

const neural::Matrix& NetworkScorer::decode(std::span<const Prefix* const> batch) {
  histories_.clear();
  for (const Prefix* prefix : batch) histories_.push_back(prefix->history);
  const neural::Index begin[] = {0, static_cast<neural::Index>(batch.size())};
  return pass_.decode(begin, histories_);
}

}  // namespace waymark::parser
