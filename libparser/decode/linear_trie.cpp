#include "libparser/decode/linear_trie.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace waymark::parser {
namespace {

// The value of a child: of a program its log weight.
float below(const LinearTrie& trie, const TrieScratch& scratch, const LinearTrie::Child& child) {
  return child.is_program() ? trie.log_weights()[child.program()] : scratch.value[child.node()];
}

void forward(const LinearTrie& trie, Scorer& scorer, TrieScratch& scratch) {
  const std::span<const LinearTrie::Node> nodes = trie.nodes();
  const std::size_t tokens = scorer.tokens();
  scratch.log_p.resize(nodes.size() * tokens);
  scratch.value.resize(nodes.size());
  scratch.groups.resize(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;) {
    const LinearTrie::Node& node = nodes[n];
    float* const log_p = scratch.log_p.data() + n * tokens;
    scratch.groups[n] = scorer.groups(node.prefix.choice);
    scorer.log_probabilities(scratch.groups[n], scorer.prefixes().choices(node.prefix), log_p);
    float highest = -INFINITY, total = 0;
    const auto value = [&](const LinearTrie::Child& c) { return log_p[c.token] + below(trie, scratch, c); };
    for (const LinearTrie::Child& c : node.children) highest = std::max(highest, value(c));
    for (const LinearTrie::Child& c : node.children) total += std::exp(value(c) - highest);
    scratch.value[n] = highest + std::log(total);
  }
}

}  // namespace

double accumulate_gradient(const LinearTrie& trie, Scorer& scorer, TrieScratch& scratch) {
  if (trie.programs() == 0) return 0;
  forward(trie, scorer, scratch);
  const std::span<const LinearTrie::Node> nodes = trie.nodes();
  const std::size_t tokens = scorer.tokens();
  scratch.mass.assign(nodes.size(), 0.0F);  // posterior probability of passing through the node
  scratch.mass[0] = 1.0F;
  scratch.delta.resize(tokens);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const float mass = scratch.mass[n];
    if (mass < 1e-6F) continue;
    const LinearTrie::Node& node = nodes[n];
    const float* const log_p = scratch.log_p.data() + n * tokens;
    const TokenRanges choices = scorer.prefixes().choices(node.prefix);
    for (const auto& [begin, end] : choices.ranges) {
      using Row = Eigen::Map<const Eigen::ArrayXf>;
      constexpr float least_exponent = -80.0F;  // below it come denormal numbers, which are slow
      Eigen::Map<Eigen::ArrayXf>(scratch.delta.data() + begin, end - begin) =
          -mass * Row(log_p + begin, end - begin).max(least_exponent).exp();
    }
    for (const LinearTrie::Child& c : node.children) {
      const float share = mass * std::exp(log_p[c.token] + below(trie, scratch, c) - scratch.value[n]);
      scratch.delta[c.token] += share;
      if (!c.is_program()) scratch.mass[c.node()] = share;
    }
    scorer.add_gradient(scratch.groups[n], choices, scratch.delta.data());
  }
  return scratch.value[0];
}

}  // namespace waymark::parser
