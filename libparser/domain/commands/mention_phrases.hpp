// The phrases of a text that may name landmarks of a city or state what a clause says, each with what counts for it.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "libparser/domain/commands/city_words.hpp"
#include "libparser/lifted/mention_weights.hpp"

namespace waymark::parser {

struct MentionPhrase {                           // words that may name a landmark
  std::size_t begin = 0, end = 0, landmark = 0;  // tokens [begin, end)
  bool negated = false;                          // they state the opposite: "the door is shut" of "the door is open"
  bool clause = false;                           // the name is a clause, which may stand beside another
  MentionVector features{};                      // all but Adjacent
};

inline constexpr std::size_t longest_phrase = 14, most_foreign = 2;  // words of a phrase; those that are no part of it

// By their ends. Phrases begin and end with words of their landmark.
std::vector<MentionPhrase> mention_phrases(const std::vector<std::string>& tokens, const CityWords& city,
                                           const Synonyms& synonyms);

}  // namespace waymark::parser
