// Mentions: which words of a text name which thing, and the text with its mentions as slots.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "libparser/lifted/lifted_network.hpp"

namespace waymark::parser {

// Something that texts may name.
struct NamedThing {
  std::string name;                               // of its proposition
  std::vector<std::vector<std::string>> phrases;  // lower case, word by word, plurals as singulars
};

struct Mention {
  std::size_t begin = 0, end = 0;  // in the tokens
  std::size_t thing = 0;           // that is named
  bool negated = false;            // the words state its opposite
};

// The longest phrases from left to right; ties: the thing that stands first. A word of five letters or more also
// matches with one letter wrong, left out, added, or exchanged with its neighbour, when no thing has it exactly and it
// is no word itself. O(tokens · phrases).
std::vector<Mention> find_mentions(const std::vector<std::string>& tokens, const std::vector<NamedThing>& things,
                                   const WordVectors* words = nullptr);

struct LiftedMentions {             // a text and its mentions
  LiftedText text;                  // its mentions are slots
  std::vector<std::size_t> things;  // of slot 1, 2 …
};
// Mentions become slots, negated ones "not" and their slots; articles before them go, unless they stay. Names that stay
// follow their slots.
enum class Articles : std::uint8_t { Go, Stay };
enum class Names : std::uint8_t { Go, Stay };
LiftedMentions lift(const std::vector<std::string>& tokens, const std::vector<Mention>& mentions,
                    Articles articles = Articles::Go, Names names = Names::Go);

// One letter wrong, missing or added, or two neighbours exchanged.
bool is_misspelled(std::string_view word, std::string_view meant);

std::string singular(std::string word);  // "lamps" → "lamp"; words that end in "ss" stay

}  // namespace waymark::parser
