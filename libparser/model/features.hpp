// Features of a sentence and a prefix of a program: what the linear model looks at when it chooses a token.
//
//   of the sentence, by context (kind of choice × which step)
//     its words, pairs of neighbours, pairs with one word between, its length
//   of the clause the open step is said by, by kind of choice alone, so that every step learns from every other
//     its words, its pairs; how many clauses are left after it
//   of a token: that the sentence mentions what it names
//   of the prefix
//     the last token, the last two
// A sentence falls into clauses at "and", "then" and marks; step i belongs to clause i, later steps to the last.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "libparser/model/program_language.hpp"
#include "libparser/model/word_table.hpp"

namespace waymark::parser {

// Which kind of choice: a step begins, or the goal has one literal, or more.
// The first steps have contexts of their own, later ones share the last; clauses are told apart as far as programs go.
inline constexpr std::size_t choice_kinds = 3, choice_steps = 3;  // of contexts

struct Choice {
  std::uint8_t kind = 0, step = 0;  // the context of a choice
  Token last = 0, before_last = 0;  // tokens of the prefix that were choices; 0 at its beginning
};
Choice first_choice();                                                             // at the beginning of a program
Choice choice_after(const PrefixState& state, const Choice& choice, Token taken);  // when that token has been taken

struct SentenceInput {              // what a model is told of a sentence
  std::vector<std::string> tokens;  // of the sentence
  bool heading_unknown = false;     // of the start
};

// Keys of the features of a sentence, by (kind, step): everything but what depends on the last tokens.
struct SentenceFeatures {
  std::array<std::vector<std::vector<std::uint64_t>>, choice_kinds> by_context;  // later steps: the last
  std::vector<Part> mentions;                                                    // lexicon.hpp
  std::vector<bool> places;  // places[n]: the sentence names the number n
};

// For programs of so many steps. New words are added to a table that may grow; otherwise they are left out.
SentenceFeatures sentence_features(const SentenceInput& input, WordTable& words, std::size_t steps = choice_steps);
SentenceFeatures sentence_features(const SentenceInput& input, const WordTable& words,
                                   std::size_t steps = choice_steps);

// Numbers of features.
std::uint64_t last_token_feature(const Choice& choice);
std::uint64_t last_two_tokens_feature(const Choice& choice);
// Active for those tokens alone whose thing is mentioned: it weighs their direction and mentioning as such.
std::uint64_t mention_feature(const Choice& choice);

// n for place_n, 0 for any other proposition. By proposition.
std::vector<std::size_t> place_numbers(const ProgramLanguage& language);

// Tokens that this sentence may not use: places it does not name, and what no goal may name. By token.
std::vector<bool> forbidden_tokens(const ProgramLanguage& language, const SentenceFeatures& features);

}  // namespace waymark::parser
