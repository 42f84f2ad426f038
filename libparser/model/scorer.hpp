// Scores of all tokens at a choice, for one sentence: sums of weight rows, shared between choices.
//
// The rows that are active at a choice fall into four groups, and many choices share each of them: the sentence in its
// context, what it mentions, the last token, the last two tokens. A group is summed once (features × columns), a choice
// adds four sums (4 × tokens), and the gradient takes the same way back.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <vector>

#include "libparser/model/features.hpp"

namespace waymark::parser {

class Scorer {
 public:
  using GroupIds = std::array<std::uint32_t, 4>;

  // The model must outlive the scorer.
  explicit Scorer(const LinearModel& model);
  Scorer(const LinearModel& model, const SentenceFeatures& features);
  // For another sentence. The features must outlive their use here.
  void begin(const SentenceFeatures& features);

  bool forbids(Token token) const { return forbidden_[token]; }
  GroupIds groups(const Choice& choice);

  // log p(token | choice) of the choices, −∞ for forbidden ones; other entries are left alone. out: [tokens]
  void log_probabilities(const GroupIds& ids, const TokenRanges& choices, float* out) const;

  // d log-likelihood / d score of each choice → the groups. delta: [tokens]
  void add_gradient(const GroupIds& ids, const TokenRanges& choices, const float* delta);
  // visit(feature, gradient [columns]) for every feature of every group.
  template <class Visit>
  void each_gradient(Visit&& visit) {
    for (std::size_t i = 0; i < used_; ++i) {
      const float* const gradient = spread_gradient(groups_[i]);
      for (std::uint64_t feature : groups_[i].features) visit(feature, gradient);
    }
  }

 private:
  struct Group {
    std::span<const std::uint64_t> features;
    bool of_mentions = false;             // its scores and gradients are those of the mentioned tokens alone
    std::uint64_t own_feature = 0;        // what `features` refers to when it is one of the prefix
    std::vector<float> scores, gradient;  // [tokens]
  };
  std::uint32_t group(std::uint64_t id, std::span<const std::uint64_t> features, bool of_mentions = false);
  void sum(Group& group);
  const float* spread_gradient(const Group& group);  // [columns], valid until the next call

  const LinearModel* model_;
  const SentenceFeatures* features_ = nullptr;
  std::vector<bool> forbidden_;
  std::vector<Token> mentioned_;
  std::deque<Group> groups_;  // the first `used_` belong to this sentence
  std::size_t used_ = 0;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;
  std::vector<float> buffer_;  // [columns]
};

}  // namespace waymark::parser
