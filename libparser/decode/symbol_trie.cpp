#include "libparser/decode/symbol_trie.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::parser {

using neural::Index;

const ChoiceMask& ChoiceMasks::of(const TypedState& state) {
  const PrefixState& p = state.prefix;
  const std::uint64_t key = std::uint64_t{state.thing} << 48U | std::uint64_t{p.last_literal} << 32U |
                            std::uint64_t{p.steps} << 24U | std::uint64_t{p.goals} << 16U |
                            std::uint64_t{p.bools} << 12U | std::uint64_t{p.step_entries} << 8U |
                            std::uint64_t{p.awaits} << 5U | std::uint64_t{p.operand} << 4U |
                            std::uint64_t{p.turns} << 3U | std::uint64_t{p.oriented} << 2U |
                            std::uint64_t{p.stayed} << 1U | std::uint64_t{p.ended};
  const auto [it, is_new] = made_.try_emplace(key);
  if (is_new) {
    const std::vector<bool> allowed = symbols_->allowed(state);
    for (Symbol v = 0; v < allowed.size(); ++v)
      if (allowed[v]) it->second.allowed.push_back(v);
    it->second.forced = symbols_->forced(state);
  }
  return it->second;
}

void log_softmax(const neural::ConstView& scores, Index column, const ChoiceMask& mask,
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

bool SymbolTrie::add(const Program& program, double weight, ChoiceMasks& masks, const History& first) {
  const std::vector<Symbol> symbols = masks.symbols().symbols_of(program);
  TypedState state;
  History history = first;
  if (nodes_.empty()) nodes_.push_back({first, &masks.of(state), {}});
  const auto take = [&](Symbol symbol) {
    state = masks.symbols().after(state, symbol);
    EncoderDecoder::remember(history, symbol);
  };
  std::size_t at = 0;
  for (std::size_t i = 0; i < symbols.size();) {
    const Symbol symbol = symbols[i++];
    take(symbol);
    for (; i < symbols.size() && masks.of(state).forced; ++i) take(symbols[i]);
    const auto& children = nodes_[at].children;
    const auto child =
        std::find_if(children.begin(), children.end(), [&](const Child& c) { return c.symbol == symbol; });
    if (child != children.end()) {
      if (child->to < 0) return false;
      at = static_cast<std::size_t>(child->to);
      continue;
    }
    if (i == symbols.size()) {
      nodes_[at].children.push_back({symbol, ~static_cast<std::int32_t>(programs())});
      break;
    }
    nodes_[at].children.push_back({symbol, static_cast<std::int32_t>(nodes_.size())});
    at = nodes_.size();
    nodes_.push_back({history, &masks.of(state), {}});
  }
  log_weights_.push_back(static_cast<float>(std::log(weight)));
  return true;
}

void SymbolTrie::append_histories(std::vector<History>& out) const {
  for (const Node& node : nodes_) out.push_back(node.history);
}

SymbolTrie::Likelihoods SymbolTrie::likelihoods(const neural::Matrix& scores, Index at,
                                                const std::vector<bool>& forbidden) const {
  const auto width = static_cast<std::size_t>(scores.rows());
  Likelihoods out{std::vector<float>(programs()), std::vector<float>(nodes_.size() * width)};
  std::vector<float> so_far(nodes_.size(), 0.0F);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    float* const log_p = out.symbols.data() + n * width;
    log_softmax(scores, at + static_cast<Index>(n), *nodes_[n].mask, forbidden, log_p);
    for (const Child& child : nodes_[n].children) {
      const float sum = so_far[n] + log_p[child.symbol];
      (child.to < 0 ? out.log_p[static_cast<std::size_t>(~child.to)]
                    : so_far[static_cast<std::size_t>(child.to)]) = sum;
    }
  }
  return out;
}

void SymbolTrie::backpropagate(const Likelihoods& likelihoods, std::span<const float> gradient,
                               neural::Matrix& dscores, Index at) const {
  const auto width = static_cast<std::size_t>(dscores.rows());
  std::vector<float> below(nodes_.size(), 0.0F);
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    auto column = dscores.col(at + static_cast<Index>(n));
    const auto part = [&](const Child& child) {
      return child.to < 0 ? gradient[static_cast<std::size_t>(~child.to)]
                          : below[static_cast<std::size_t>(child.to)];
    };
    for (const Child& child : nodes_[n].children) below[n] += part(child);
    const float* const log_p = likelihoods.symbols.data() + n * width;
    column.setZero();
    for (const Symbol v : nodes_[n].mask->allowed) column(v) = -below[n] * std::exp(log_p[v]);
    for (const Child& child : nodes_[n].children) column(child.symbol) += part(child);
  }
}

}  // namespace waymark::parser
