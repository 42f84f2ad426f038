#include "libparser/corpus/token.hpp"

#include <algorithm>
#include <array>

namespace waymark::parser {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 4> sides{
    {{"left", "right"}, {"lefthand", "righthand"}, {"left-hand", "right-hand"}, {"lefts", "rights"}}};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
bool is_mark(char c) { return std::string_view(",;:.?!()\"%").find(c) != std::string_view::npos; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// "isn't" → is n't, "n't" → n't (words split before stay so), "it's" → it s, "walls'" → walls.
void add_word(std::string_view word, std::vector<std::string>& tokens) {
  if (word.size() >= 3 && word.substr(word.size() - 3) == "n't") {
    if (word.size() > 3) tokens.emplace_back(word.substr(0, word.size() - 3));
    tokens.emplace_back("n't");
    return;
  }
  for (std::size_t begin = 0; begin <= word.size();) {
    const std::size_t end = std::min(word.find('\'', begin), word.size());
    if (end > begin) tokens.emplace_back(word.substr(begin, end - begin));
    begin = end + 1;
  }
}

bool cuts_clause(const std::string& word) {
  for (const char* cut : {"and", "then", ",", ";", ":", "."})
    if (word == cut) return true;
  return false;
}

}  // namespace

std::vector<std::string> tokenize(std::string_view text) {
  std::vector<std::string> tokens;
  std::string word;
  const auto flush = [&] {
    add_word(word, tokens);
    word.clear();
  };
  for (char c : text) {
    if (is_space(c) || is_mark(c)) flush();
    if (is_mark(c)) tokens.emplace_back(1, c);
    if (!is_space(c) && !is_mark(c)) word += lower(c);
  }
  flush();
  return tokens;
}

std::vector<std::string> split_sentences(std::string_view text) {
  std::vector<std::string> sentences;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t cut = std::min(text.find_first_of(".;!?", begin), text.size() - 1);
    std::string sentence(text.substr(begin, cut + 1 - begin));
    bool has_word = false;
    for (char c : sentence) has_word = has_word || !(is_space(c) || is_mark(c));
    if (has_word) sentences.push_back(std::move(sentence));
    begin = cut + 1;
  }
  return sentences;
}

std::vector<Clause> clauses_of(const std::vector<std::string>& tokens) {
  std::vector<Clause> clauses;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= tokens.size(); ++i) {
    if (i < tokens.size() && !cuts_clause(tokens[i])) continue;
    if (i > begin) clauses.push_back({begin, i});
    begin = i + 1;
  }
  if (clauses.empty()) clauses.push_back({0, tokens.size()});
  return clauses;
}

std::optional<Side> side_of(std::string_view word) {
  for (const auto& [left, right] : sides)
    if (word == left || word == right) return word == left ? Side::Left : Side::Right;
  return std::nullopt;
}

std::vector<std::string> mirror(std::vector<std::string> tokens) {
  for (std::string& word : tokens)
    for (const auto& [left, right] : sides)
      if (word == left || word == right) {
        word = word == left ? right : left;
        break;
      }
  return tokens;
}

}  // namespace waymark::parser
