#include "libparser/grounding/missing_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace waymark::parser {
namespace {

constexpr std::size_t longest_name = 3, most_nearest = 3, few_readings = 3;
constexpr double least_with_name = 0.5;  // probability of having understood the text with the name in place
constexpr double nearly = 0.95;       // a later or longer span replaces one that reads a little better: names are long
constexpr double least_alike = 0.35;  // cosine of word vectors

bool is_among(const auto& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_article(std::string_view word) {
  constexpr std::array<std::string_view, 9> articles{"the", "a", "an", "my", "your", "some", "any", "this", "that"};
  return is_among(articles, word);
}

bool begins_name(std::string_view before) {
  constexpr std::array<std::string_view, 10> prepositions{"to",      "at", "by", "near", "past",
                                                          "through", "on", "of", "for",  "from"};
  return is_article(before) || is_among(prepositions, before);
}

bool is_word(std::string_view token) {
  return token[0] != '#' && std::any_of(token.begin(), token.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 128;
         });
}

// Tokens [begin, end) become one more slot; slots are numbered by first mention again.
LiftedText with_name(const LiftedText& text, std::size_t begin, std::size_t end) {
  LiftedText out = text;
  out.tokens.assign(text.tokens.begin(), text.tokens.begin() + static_cast<std::ptrdiff_t>(begin));
  out.tokens.emplace_back("#new");
  out.tokens.insert(out.tokens.end(), text.tokens.begin() + static_cast<std::ptrdiff_t>(end), text.tokens.end());
  std::vector<std::string> met;
  for (std::string& token : out.tokens) {
    if (token.size() < 2 || token[0] != '#') continue;
    auto at = std::find(met.begin(), met.end(), token);
    if (at == met.end()) at = met.insert(met.end(), token);
    token = name(slot(static_cast<std::size_t>(at - met.begin()) + 1));
  }
  out.scope.slots = met.size();
  return out;
}

double understood(const LiftedReader& reader, const LiftedText& text) {
  double p = 0;
  for (const LiftedReading& reading : reader.read(text, few_readings))
    if (reading.lifted.front() != LiftedSymbol::Nothing) p += std::exp(reading.log_probability);
  return p;
}

double alike(const WordVectors& vectors, const std::string& word, const NamedThing& thing) {
  double best = 0;
  for (const auto& phrase : thing.phrases) {
    if (is_misspelled(word, phrase.back())) return 1;
    const auto a = vectors.find(word), b = vectors.find(phrase.back());
    if (a && b) best = std::max(best, vectors.similarity(*a, *b));
  }
  return best;
}

}  // namespace

std::optional<MissingName> missing_name(const LiftedReader& reader, const LiftedText& text,
                                        const std::vector<NamedThing>& things) {
  const auto& tokens = text.tokens;
  if (text.scope.slots >= 12) return std::nullopt;
  double best = least_with_name;
  std::pair<std::size_t, std::size_t> span;
  for (std::size_t begin = 1; begin < tokens.size(); ++begin) {
    if (!begins_name(tokens[begin - 1]) || is_article(tokens[begin])) continue;
    const std::size_t from = is_article(tokens[begin - 1]) ? begin - 1 : begin;
    for (std::size_t end = begin; end < std::min(begin + longest_name, tokens.size()) && is_word(tokens[end]); ++end)
      if (const double p = understood(reader, with_name(text, from, end + 1)); p > best) {
        best = nearly * p;
        span = {begin, end + 1};
      }
  }
  if (span.first == span.second) return std::nullopt;
  MissingName missing;
  for (std::size_t i = span.first; i < span.second; ++i) missing.words += (i > span.first ? " " : "") + tokens[i];
  std::vector<std::pair<double, std::string>> near;
  for (const NamedThing& thing : things)
    if (const double a = alike(reader.vectors(), singular(tokens[span.second - 1]), thing); a >= least_alike)
      near.emplace_back(-a, thing.name);
  std::sort(near.begin(), near.end());
  for (std::size_t i = 0; i < std::min(near.size(), most_nearest); ++i) {
    std::replace(near[i].second.begin(), near[i].second.end(), '_', ' ');
    missing.nearest.push_back(near[i].second);
  }
  return missing;
}

}  // namespace waymark::parser
