// The phrases of a text that may name landmarks of a city, and the log-linear model over covers: sets of phrases that
// do not overlap. It is a semi-Markov conditional random field [SC04, Sec. 2]:
//   p(cover | text) ∝ exp(Σ over its phrases of weights · features)
// with the weight Adjacent for each phrase beside the one before, unless it is for a clause.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "libparser/domain/commands/city_words.hpp"
#include "libparser/domain/commands/mention_phrases.hpp"
#include "libparser/lifted/mention_weights.hpp"

namespace waymark::parser {

struct Cover {                       // one way to find mentions
  std::vector<std::size_t> phrases;  // of the lattice, from left to right
  double score = 0;                  // log of its weight
};

class MentionLattice {
 public:
  // O(tokens · phrases).
  MentionLattice(const std::vector<std::string>& tokens, const CityWords& city, const Synonyms& synonyms);

  std::span<const MentionPhrase> phrases() const { return phrases_; }
  // The k covers of most weight, best first; the empty cover is one of them. O(phrases · k log k).
  std::vector<Cover> best(const MentionVector& weights, std::size_t k) const;
  // The sum of the features of phrases that do not overlap, from left to right, Adjacent with them.
  MentionVector features(std::span<const std::size_t> phrases) const;
  // log Σ of the weights of all covers, and the expected features. With `wanted`: of the covers that name just these
  // landmarks, each at least once; -∞ when there is none. At most 8 are wanted. O(phrases · 2^wanted).
  double log_sum(const MentionVector& weights, MentionVector& expected,
                 const std::vector<std::size_t>* wanted = nullptr) const;

 private:
  bool is_beside(const MentionPhrase& phrase, std::size_t ended) const {
    return !phrase.clause && before_[phrase.begin] == ended;
  }

  std::size_t tokens_ = 0;
  std::vector<std::size_t> before_;     // for each token: where the words end that do not separate it from a phrase
  std::vector<MentionPhrase> phrases_;  // by their ends
};

}  // namespace waymark::parser
