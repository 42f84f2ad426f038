// The phrases of a text that may name landmarks of a city, and the log-linear model over covers: sets of phrases that
// do not overlap. It is a semi-Markov conditional random field [SC04, Sec. 2]:
//   p(cover | text) ∝ exp(Σ over its phrases of weights · features)
// with the weight Adjacent for each phrase beside the one before.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "libparser/domain/commands/city_words.hpp"
#include "libparser/lifted/mention_weights.hpp"

namespace waymark::parser {

struct MentionPhrase {                           // words that may name a landmark
  std::size_t begin = 0, end = 0, landmark = 0;  // tokens [begin, end)
  MentionVector features{};                      // all but Adjacent
};

struct Cover {                       // one way to find mentions
  std::vector<std::size_t> phrases;  // of the lattice, from left to right
  double score = 0;                  // log of its weight
};

class MentionLattice {
 public:
  static constexpr std::size_t longest_phrase = 14, most_foreign = 2;  // words

  // Phrases begin and end with words of their landmark. O(tokens · phrases).
  MentionLattice(const std::vector<std::string>& tokens, const CityWords& city, const Synonyms& synonyms);

  std::span<const MentionPhrase> phrases() const { return phrases_; }
  // The k covers of most weight, best first; the empty cover is one of them. O(phrases · k log k).
  std::vector<Cover> best(const MentionVector& weights, std::size_t k) const;
  // log Σ of the weights of all covers, and the expected features. With `wanted`: of the covers that name just these
  // landmarks, each at least once; -∞ when there is none. At most 8 are wanted. O(phrases · 2^wanted).
  double log_sum(const MentionVector& weights, MentionVector& expected,
                 const std::vector<std::size_t>* wanted = nullptr) const;

 private:
  std::size_t tokens_ = 0;
  std::vector<std::size_t> before_;     // for each token: where the words end that do not separate it from a phrase
  std::vector<MentionPhrase> phrases_;  // by their ends
};

}  // namespace waymark::parser
