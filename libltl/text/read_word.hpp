// Text → word: the inverse of show (word.hpp).
//
//   {a, b}; {}; {"meeting room"}     a finite word, letter by letter
//   {a}; ({b}; {})ʷ                  a lasso u·vʷ; ^w, w and ω stand for ʷ
//   a b; ; c                         the same without braces: names with blanks or commas between them
// The names of a letter are identifiers, or texts in double quotes. A ';' behind the last letter adds no letter.
#pragma once
#include <string_view>
#include <variant>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"

namespace waymark::ltl {

using AnyWord = std::variant<Trace, Lasso>;  // finite or infinite

// New names are added to the vocabulary. Throw SyntaxError. O(|text|).
AnyWord read_word(std::string_view text, Vocabulary& vocabulary);
Letter read_letter(std::string_view text, Vocabulary& vocabulary);

}  // namespace waymark::ltl
