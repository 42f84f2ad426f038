#include "libparser/supervision/place_numbers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "libparser/lexicon/lexicon.hpp"

namespace waymark::parser {
namespace {

template <std::size_t size>
bool one_of(std::string_view word, const std::array<std::string_view, size>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "position", short or misspelled, and its synonyms.
bool names_places(std::string_view word) {
  constexpr std::array<std::string_view, 6> others{"p", "#", "place", "number", "spot", "location"};
  return word.substr(0, 3) == "pos" || one_of(word, others);
}

// "p-3", "pos5", "#5"
bool joins_place_and_number(const std::string& word) {
  const std::size_t digits = std::min(word.find_first_of("0123456789"), word.size());
  std::string_view name = std::string_view(word).substr(0, digits);
  while (name.size() > 1 && name.back() == '-') name.remove_suffix(1);
  return names_places(name) && number_named(word.substr(digits)) > 0;
}

bool is_place_number(const std::vector<std::string>& tokens, std::size_t i) {
  const std::string& word = tokens[i];
  if (joins_place_and_number(word)) return true;
  if (number_named(word) == 0) return false;
  const std::string_view before = i > 0 ? std::string_view(tokens[i - 1]) : std::string_view();
  if (names_places(before)) return true;
  if (word == "one") return false;  // also a pronoun
  constexpr std::array<std::string_view, 2> where{"at", "from"};
  constexpr std::array<std::string_view, 3> being{"is", "are", "be"};
  constexpr std::array<std::string_view, 4> ends{".", ",", ";", "!"};
  constexpr std::array<std::string_view, 3> verbs{"is", "has", "should"};
  const bool last = i + 1 == tokens.size() || one_of(tokens[i + 1], ends);
  return one_of(before, where) || (one_of(before, being) && last) || (!last && one_of(tokens[i + 1], verbs));
}

}  // namespace

std::vector<std::string> without_place_numbers(const std::vector<std::string>& tokens) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (!is_place_number(tokens, i)) out.push_back(tokens[i]);
  return out;
}

void hide_place_numbers(Corpus& corpus) {
  for (Paragraph& paragraph : corpus.paragraphs)
    for (Sentence& sentence : paragraph.sentences) sentence.tokens = without_place_numbers(sentence.tokens);
}

}  // namespace waymark::parser
