#include "libparser/decode/network_trie.hpp"

#include <cmath>

namespace waymark::parser {

using neural::Index;

void append_histories(const NetworkTrie& trie, std::vector<History>& out) {
  for (const NetworkTrie::Node& node : trie.nodes()) out.push_back(node.prefix.history);
}

Likelihoods likelihoods(const NetworkTrie& trie, const neural::Matrix& scores, Index at,
                        const std::vector<bool>& forbidden) {
  const std::span<const NetworkTrie::Node> nodes = trie.nodes();
  const auto width = static_cast<std::size_t>(scores.rows());
  Likelihoods out{std::vector<float>(trie.programs()), std::vector<float>(nodes.size() * width)};
  std::vector<float> so_far(nodes.size(), 0.0F);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    float* const log_p = out.symbols.data() + n * width;
    log_softmax(scores, at + static_cast<Index>(n), *nodes[n].prefix.mask, forbidden, log_p);
    for (const NetworkTrie::Child& child : nodes[n].children) {
      const float sum = so_far[n] + log_p[child.token];
      (child.is_program() ? out.log_p[child.program()] : so_far[child.node()]) = sum;
    }
  }
  return out;
}

void backpropagate(const NetworkTrie& trie, const Likelihoods& likelihoods, std::span<const float> gradient,
                   neural::Matrix& dscores, Index at) {
  const std::span<const NetworkTrie::Node> nodes = trie.nodes();
  const auto width = static_cast<std::size_t>(dscores.rows());
  std::vector<float> below(nodes.size(), 0.0F);
  for (std::size_t n = nodes.size(); n-- > 0;) {
    auto column = dscores.col(at + static_cast<Index>(n));
    const auto part = [&](const NetworkTrie::Child& child) {
      return child.is_program() ? gradient[child.program()] : below[child.node()];
    };
    for (const NetworkTrie::Child& child : nodes[n].children) below[n] += part(child);
    const float* const log_p = likelihoods.symbols.data() + n * width;
    column.setZero();
    for (const Symbol v : nodes[n].prefix.mask->allowed) column(v) = -below[n] * std::exp(log_p[v]);
    for (const NetworkTrie::Child& child : nodes[n].children) column(child.token) += part(child);
  }
}

}  // namespace waymark::parser
