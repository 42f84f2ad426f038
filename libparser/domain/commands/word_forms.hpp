// Which English words are forms of one another: inflections ("run", "runs", "running", "ran"), nouns and adjectives
// that are derived ("closure", "closed"; "unlocked"), short forms ("lib", "msg"); and words that name nothing by
// themselves.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace waymark::parser {

std::string base_form(const std::string& word);  // of an irregular one: "written" → "write"; others stay
// Whether what follows the letters that two words share are endings of inflection or derivation. Words are in base
// form.
bool same_family(std::string_view a, std::string_view b);
// "unlocked" → "locked"; none without a prefix that negates.
std::optional<std::string> without_negation(const std::string& word);
// "lib" or "lbr" of "library".
bool is_short_form(std::string_view word, std::string_view meant);

bool is_function_word(std::string_view word);  // "when", "them": misspells and shortens no other
bool is_light_word(std::string_view word);     // "be", "gets", "must": stands in a clause without saying what holds
bool negates(std::string_view word);           // "not", "n't", "no"

}  // namespace waymark::parser
