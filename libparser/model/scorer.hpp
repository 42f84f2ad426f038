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
#include "libparser/model/linear_model.hpp"

namespace waymark::parser {

// A prefix of a program, as the linear model sees it.
struct LinearPrefix {
  PrefixState state;                          // of the grammar
  Choice choice;                              // the context of the next token
  bool ended() const { return state.ended; }  // is the program complete?
};

// Prefixes of the linear model: what follows them of necessity is taken with each token. The grammar must outlive it.
class LinearPrefixes {
 public:
  using Prefix = LinearPrefix;
  explicit LinearPrefixes(const PostfixGrammar& grammar) : grammar_(&grammar) {}
  Prefix first() const { return {{}, first_choice()}; }  // the empty one
  // Appends the tokens that were taken.
  Prefix after(const Prefix& prefix, Token token, std::vector<Token>& taken) const;
  TokenRanges choices(const Prefix& prefix) const { return grammar_->choices(prefix.state); }
  std::vector<Token> tokens_of(const Program& program) const { return grammar_->tokens_of(program); }
  Program program_of(std::span<const Token> tokens) const { return grammar_->program_of(tokens); }

 private:
  const PostfixGrammar* grammar_;
};

class Scorer {
 public:
  using Prefix = LinearPrefix;
  static constexpr std::size_t at_once = 1;       // prefixes that the search gives to log_p together
  using GroupIds = std::array<std::uint32_t, 4>;  // rows of weights that choices share

  // The model must outlive the scorer.
  explicit Scorer(const LinearModel& model);
  Scorer(const LinearModel& model, const SentenceFeatures& features);
  // For another sentence. The features must outlive their use here.
  void begin(const SentenceFeatures& features);

  std::size_t tokens() const { return model_->language.columns().tokens; }                // of the language
  LinearPrefixes prefixes() const { return LinearPrefixes(model_->language.grammar()); }  // of the language
  // visit(i, token, log p(token | batch[i], sentence)) for every token that may follow.
  template <class Visit>
  void log_p(std::span<const Prefix* const> batch, const Visit& visit) {
    std::vector<float> out(tokens());
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const TokenRanges choices = prefixes().choices(*batch[i]);
      log_probabilities(groups(batch[i]->choice), choices, out.data());
      choices.each([&](Token token) { visit(i, token, out[token]); });
    }
  }

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

// Calls use(scorer).
template <class Use>
auto with_scorer(const LinearModel& model, const SentenceInput& input, const Use& use) {
  const SentenceFeatures features = sentence_features(input, model.words, model.language.steps());
  Scorer scorer(model, features);
  return use(scorer);
}

}  // namespace waymark::parser
