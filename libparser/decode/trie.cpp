#include "libparser/decode/trie.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace waymark::parser {

ProgramTrie::ProgramTrie(const PostfixGrammar& grammar)
    : grammar_(&grammar), nodes_{{PrefixState{}, first_choice(), {}}} {}

bool ProgramTrie::add(const Program& program, double weight) {
  const std::vector<Token> tokens = grammar_->tokens_of(program);
  std::size_t at = 0;
  for (std::size_t i = 0; i < tokens.size();) {
    const Token token = tokens[i++];
    PrefixState state = grammar_->after(nodes_[at].state, token);
    for (; i < tokens.size() && grammar_->forced(state); ++i) state = grammar_->after(state, tokens[i]);
    const auto& children = nodes_[at].children;
    const auto child =
        std::find_if(children.begin(), children.end(), [&](const Child& c) { return c.token == token; });
    if (child != children.end()) {
      if (child->node < 0) return false;
      at = static_cast<std::size_t>(child->node);
      continue;
    }
    const bool complete = i == tokens.size();
    nodes_[at].children.push_back({token, complete ? -1 : static_cast<std::int32_t>(nodes_.size()),
                                   static_cast<float>(std::log(weight))});
    if (complete) break;
    nodes_.push_back({state, choice_after(state, nodes_[at].choice, token), {}});
    at = nodes_.size() - 1;
  }
  ++programs_;
  return true;
}

void ProgramTrie::forward(Scorer& scorer, Scratch& scratch) const {
  const std::size_t tokens = grammar_->tokens();
  scratch.log_p.resize(nodes_.size() * tokens);
  scratch.value.resize(nodes_.size());
  scratch.groups.resize(nodes_.size());
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    float* const log_p = scratch.log_p.data() + n * tokens;
    scratch.groups[n] = scorer.groups(node.choice);
    scorer.log_probabilities(scratch.groups[n], grammar_->choices(node.state), log_p);
    float highest = -INFINITY, total = 0;
    const auto value = [&](const Child& c) {
      return log_p[c.token] + (c.node < 0 ? c.log_weight : scratch.value[static_cast<std::size_t>(c.node)]);
    };
    for (const Child& c : node.children) highest = std::max(highest, value(c));
    for (const Child& c : node.children) total += std::exp(value(c) - highest);
    scratch.value[n] = highest + std::log(total);
  }
}

double ProgramTrie::accumulate_gradient(Scorer& scorer, Scratch& scratch) const {
  if (programs_ == 0) return 0;
  forward(scorer, scratch);
  const std::size_t tokens = grammar_->tokens();
  scratch.mass.assign(nodes_.size(), 0.0F);  // posterior probability of passing through the node
  scratch.mass[0] = 1.0F;
  scratch.delta.resize(tokens);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const float mass = scratch.mass[n];
    if (mass < 1e-6F) continue;
    const Node& node = nodes_[n];
    const float* const log_p = scratch.log_p.data() + n * tokens;
    const TokenRanges choices = grammar_->choices(node.state);
    for (const auto& [begin, end] : choices.ranges) {
      using Row = Eigen::Map<const Eigen::ArrayXf>;
      constexpr float least_exponent = -80.0F;  // below it come denormal numbers, which are slow
      Eigen::Map<Eigen::ArrayXf>(scratch.delta.data() + begin, end - begin) =
          -mass * Row(log_p + begin, end - begin).max(least_exponent).exp();
    }
    for (const Child& c : node.children) {
      const float below = c.node < 0 ? c.log_weight : scratch.value[static_cast<std::size_t>(c.node)];
      const float share = mass * std::exp(log_p[c.token] + below - scratch.value[n]);
      scratch.delta[c.token] += share;
      if (c.node >= 0) scratch.mass[static_cast<std::size_t>(c.node)] = share;
    }
    scorer.add_gradient(scratch.groups[n], choices, scratch.delta.data());
  }
  return scratch.value[0];
}

}  // namespace waymark::parser
