#include "libparser/model/scorer.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace waymark::parser {
namespace {

using Row = Eigen::Map<const Eigen::ArrayXf>;
using MutableRow = Eigen::Map<Eigen::ArrayXf>;
constexpr float least_exponent = -80.0F;  // e^x is next to nothing, yet no denormal number, which would be slow

}  // namespace

LinearPrefix LinearPrefixes::after(const Prefix& prefix, Token token, std::vector<Token>& taken) const {
  PrefixState state = prefix.state;
  for (std::optional<Token> next = token; next; next = grammar_->forced(state)) {
    state = grammar_->after(state, *next);
    taken.push_back(*next);
  }
  return {state, choice_after(state, prefix.choice, token)};
}

Scorer::Scorer(const LinearModel& model) : model_(&model), buffer_(model.language.columns().size()) {}

Scorer::Scorer(const LinearModel& model, const SentenceFeatures& features) : Scorer(model) { begin(features); }

void Scorer::begin(const SentenceFeatures& features) {
  features_ = &features;
  forbidden_ = forbidden_tokens(model_->language, features);
  used_ = 0;
  index_.clear();
  const Columns& columns = model_->language.columns();
  mentioned_.clear();
  for (std::size_t t = 0; t < columns.tokens; ++t) {
    if (std::binary_search(features.mentions.begin(), features.mentions.end(), columns.part(columns.thing[t])))
      mentioned_.push_back(static_cast<Token>(t));
  }
}

void Scorer::sum(Group& group) {
  const Columns& columns = model_->language.columns();
  std::fill(buffer_.begin(), buffer_.end(), 0.0F);
  float* const out = buffer_.data();
  for (std::uint64_t feature : group.features) {
    if (const auto row = model_->weights.find(feature)) model_->weights.add_to(*row, out);
  }
  if (group.of_mentions) {
    std::fill(group.scores.begin(), group.scores.end(), 0.0F);
    for (Token t : mentioned_) group.scores[t] = out[columns.mention] + out[columns.direction[t]];
    return;
  }
  for (std::size_t t = 0; t < columns.tokens; ++t)
    group.scores[t] = out[t] + out[columns.direction[t]] + out[columns.thing[t]];
}

// An empty `features` stands for the one feature whose key is `id` itself.
std::uint32_t Scorer::group(std::uint64_t id, std::span<const std::uint64_t> features, bool of_mentions) {
  const auto [it, is_new] = index_.try_emplace(id, static_cast<std::uint32_t>(used_));
  if (!is_new) return it->second;
  const std::size_t tokens = model_->language.columns().tokens;
  if (used_ == groups_.size())
    groups_.push_back({{}, false, 0, std::vector<float>(tokens), std::vector<float>(tokens)});
  Group& group = groups_[used_++];
  group.of_mentions = of_mentions;
  group.own_feature = id;
  group.features = features.empty() ? std::span<const std::uint64_t>(&group.own_feature, 1) : features;
  std::fill(group.gradient.begin(), group.gradient.end(), 0.0F);
  sum(group);
  return it->second;
}

Scorer::GroupIds Scorer::groups(const Choice& c) {
  const auto& by_step = features_->by_context[c.kind];
  const std::size_t step = std::min<std::size_t>(c.step, by_step.size() - 1), context = c.kind + choice_kinds * step;
  const std::size_t before = used_;
  const std::uint32_t sentence = group(context, by_step[step]);
  if (used_ > before)  // forbidden once, in the group that every choice of this context has
    for (std::size_t t = 0; t < forbidden_.size(); ++t)
      if (forbidden_[t]) groups_[sentence].scores[t] = -INFINITY;
  return {sentence, group(mention_feature(c), {}, true), group(last_token_feature(c), {}),
          group(last_two_tokens_feature(c), {})};
}

void Scorer::log_probabilities(const GroupIds& ids, const TokenRanges& choices, float* out) const {
  float highest = -INFINITY;
  for (const auto& [begin, end] : choices.ranges) {
    if (begin == end) continue;
    const auto of_group = [&, at = begin, n = end - begin](std::size_t g) {
      return Row(groups_[ids[g]].scores.data() + at, n);
    };
    auto sums = MutableRow(out + begin, end - begin);
    sums = of_group(0) + of_group(1) + of_group(2) + of_group(3);
    highest = std::max(highest, sums.maxCoeff());
  }
  float total = 0;
  for (const auto& [begin, end] : choices.ranges)
    if (begin < end) total += (MutableRow(out + begin, end - begin) - highest).max(least_exponent).exp().sum();
  const float log_total = highest + std::log(total);
  for (const auto& [begin, end] : choices.ranges) MutableRow(out + begin, end - begin) -= log_total;
}

void Scorer::add_gradient(const GroupIds& ids, const TokenRanges& choices, const float* delta) {
  for (std::uint32_t id : ids) {
    float* const gradient = groups_[id].gradient.data();
    choices.each([&](Token t) { gradient[t] += delta[t]; });
  }
}

const float* Scorer::spread_gradient(const Group& group) {
  const Columns& columns = model_->language.columns();
  std::fill(buffer_.begin(), buffer_.end(), 0.0F);
  if (group.of_mentions) {
    for (Token t : mentioned_) {
      buffer_[columns.mention] += group.gradient[t];
      buffer_[columns.direction[t]] += group.gradient[t];
    }
    return buffer_.data();
  }
  for (std::size_t t = 0; t < columns.tokens; ++t) {
    const float g = group.gradient[t];
    buffer_[t] = g;
    buffer_[columns.direction[t]] += g;
    buffer_[columns.thing[t]] += g;
  }
  return buffer_.data();
}

}  // namespace waymark::parser
