// The most probable programs of a sentence, best first, exactly, under any word model.
//
// p(prefix) bounds p(every completion), so taking the likeliest open prefix first yields complete programs in order
// of probability; the beam is the number of complete programs wanted. Only well-typed prefixes are ever made. Prefixes
// are expanded a batch at a time where that is cheaper; a program is given when no open prefix is likelier.
#pragma once
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "libparser/model/word_model.hpp"

namespace waymark::parser {

struct Candidate {             // a complete program
  Program program;             // of the model
  double log_probability = 0;  // given the sentence
};

template <WordScorer Scores>
class BestFirst {
 public:
  explicit BestFirst(Scores& scores) : scores_(scores), prefixes_(scores.prefixes()) {
    made_.push_back({prefixes_.first(), none, 0, 0.0F});
    open_.push({0.0F, 0});
  }

  // At most beam programs; stops after so many expansions.
  std::vector<Candidate> run(std::size_t beam, std::size_t expansions) {
    while (!open_.empty() && found_.size() < beam) {
      const std::vector<std::size_t> batch = next_batch(beam);
      if (batch.empty() || expansions < batch.size()) break;
      expansions -= batch.size();
      expand(batch);
    }
    return std::move(found_);
  }

 private:
  using Prefix = typename Scores::Prefix;
  static constexpr float least = -12.0F;  // log-probability below which a prefix is not worth keeping
  static constexpr std::size_t none = SIZE_MAX;

  struct Made {
    Prefix prefix;
    std::size_t parent;  // none: the empty prefix
    Token token;         // the choice that led here
    float log_probability;
  };
  struct Open {
    float log_probability;
    std::size_t prefix;
    friend bool operator<(const Open& a, const Open& b) {  // ties: the one made first
      return a.log_probability != b.log_probability ? a.log_probability < b.log_probability : a.prefix > b.prefix;
    }
  };

  // The likeliest prefixes to be expanded; programs that are likelier than all of them are given.
  std::vector<std::size_t> next_batch(std::size_t beam) {
    std::vector<std::size_t> batch;
    std::vector<Open> ended;  // behind prefixes that are not expanded yet
    while (!open_.empty() && batch.size() < Scores::at_once && ended.size() < Scores::at_once) {
      const Open top = open_.top();
      open_.pop();
      if (!made_[top.prefix].prefix.ended()) {
        batch.push_back(top.prefix);
      } else if (batch.empty()) {
        found_.push_back({program_to(top.prefix), top.log_probability});
        if (found_.size() == beam) return {};
      } else {
        ended.push_back(top);
      }
    }
    for (const Open& later : ended) open_.push(later);
    return batch;
  }

  void expand(const std::vector<std::size_t>& batch) {
    std::vector<const Prefix*> prefixes;
    for (const std::size_t at : batch) prefixes.push_back(&made_[at].prefix);
    struct Kept {
      std::size_t parent;
      Token token;
      float log_probability;
    };
    std::vector<Kept> kept;
    scores_.log_p(prefixes, [&](std::size_t i, Token token, float log_p) {
      const float sum = made_[batch[i]].log_probability + log_p;
      if (sum >= least) kept.push_back({batch[i], token, sum});
    });
    std::vector<Token> taken;
    for (const auto& [parent, token, sum] : kept) {
      taken.clear();
      open_.push({sum, made_.size()});
      made_.push_back({prefixes_.after(made_[parent].prefix, token, taken), parent, token, sum});
    }
  }

  Program program_to(std::size_t at) const {
    std::vector<Token> choices;
    for (; made_[at].parent != none; at = made_[at].parent) choices.push_back(made_[at].token);
    std::vector<Token> tokens;
    Prefix prefix = prefixes_.first();
    for (auto choice = choices.rbegin(); choice != choices.rend(); ++choice)
      prefix = prefixes_.after(prefix, *choice, tokens);
    return prefixes_.program_of(tokens);
  }

  Scores& scores_;
  decltype(scores_.prefixes()) prefixes_;
  std::vector<Made> made_;
  std::priority_queue<Open> open_;
  std::vector<Candidate> found_;
};

extern template class BestFirst<Scorer>;  // made in grounder.cpp, with the options of the library
extern template class BestFirst<NetworkScorer>;

// At most `beam` programs, none of probability below e⁻¹²; fewer when `expansions` prefixes did not suffice.
// Deterministic: ties by order of making.
template <WordScorer Scores>
std::vector<Candidate> best_programs(Scores& scores, std::size_t beam, std::size_t expansions = 2000) {
  return BestFirst<Scores>(scores).run(beam, expansions);
}

}  // namespace waymark::parser
