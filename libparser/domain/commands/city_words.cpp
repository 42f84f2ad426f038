#include "libparser/domain/commands/city_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "libparser/corpus/token.hpp"
#include "libparser/mention/mention.hpp"

namespace waymark::parser {
namespace {

template <std::size_t n>
bool is_among(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}
constexpr std::array<std::string_view, 41> joints{
    "operated", "specializing", "specialize", "your",  "the",   "a",       "an",       "on",     "at",    "of",
    "in",       "with",         "that",       "and",   "&",     "'s",      "s",        "for",    "by",    "near",
    "serves",   "serving",      "called",     "named", "which", "is",      "to",       "-",      ".",     "from",
    "its",      "it",           "has",        "known", "as",    "located", "offering", "offers", "sells", "selling",
    "where"};
constexpr std::array<std::string_view, 42> command_words{
    "travel", "turn",  "right",  "left", "north",   "south",  "east", "west", "head",  "straight", "walk",
    "way",    "stop",  "around", "next", "finally", "no",     "now",  "go",   "visit", "then",     "avoid",
    "you",    "must",  "reach",  "move", "until",   "never",  "not",  "once", "twice", "times",    "before",
    "after",  "first", "only",   "or",   "if",      "always", "keep", "end",  "stay"};
constexpr std::array<std::string_view, 27> told_tags{
    "amenity",      "cuisine",          "shop",     "building",     "leisure",
    "tourism",      "office",           "religion", "addr:street",  "addr:housenumber",
    "denomination", "operator",         "historic", "man_made",     "memorial",
    "power",        "landuse",          "natural",  "waterway",     "railway",
    "highway",      "public_transport", "sport",    "artwork_type", "healthcare",
    "brand",        description_tag};
constexpr std::array<std::string_view, 10> general{"building", "place", "store", "shop",     "location",
                                                   "site",     "area",  "spot",  "landmark", "establishment"};

std::vector<std::string> roots(const std::string& text) {
  std::string plain = without_accents(text);
  for (char& c : plain)
    if (c == '_' || c == ';' || c == '-' || c == '/') c = ' ';
  for (std::size_t at = 0; (at = plain.find('&', at)) != std::string::npos; at += 3) plain.replace(at, 1, " & ");
  std::vector<std::string> out;
  for (std::string& token : tokenize(plain)) out.push_back(word_root(std::move(token)));
  return out;
}

void add_name(CityWords::Names& names, const std::string& name) {
  std::set<std::string> words;
  names.sequences.push_back(roots(name));
  for (const std::string& word : names.sequences.back())
    if (!is_joint(word) && word.find_first_of(",.;:!?'\"()") == std::string::npos) words.insert(word);
  names.name_words.insert(words.begin(), words.end());
  if (!words.empty()) names.words.push_back(std::move(words));
}

CityWords::Names names_of(const Landmark& landmark) {
  CityWords::Names out;
  add_name(out, landmark.name);
  for (const std::string& other : landmark.other_names) add_name(out, other);
  for (const char* key : {"short_name", "alt_name", "official_name", "old_name", "name:en"})
    if (const auto tag = landmark.tags.find(key); tag != landmark.tags.end()) add_name(out, tag->second);
  out.own = out.sequences.size();
  for (const char* key : {"brand", "operator"})
    if (const auto tag = landmark.tags.find(key); tag != landmark.tags.end()) add_name(out, tag->second);
  for (const auto& [key, value] : landmark.tags) {
    if (!is_among(told_tags, key) || value == "no") continue;
    for (std::string& word : roots(value == "yes" ? key : value)) out.tag_words.insert(word);
    if (key.find(':') == std::string::npos && key != "brand" && key != "operator")
      for (std::string& word : roots(key)) out.tag_words.insert(word);
  }
  return out;
}

}  // namespace

std::string word_root(std::string word) {
  word = singular(std::move(word));
  static const std::map<std::string, std::string, std::less<>> same{{"st", "street"},
                                                                    {"ave", "avenue"},
                                                                    {"blvd", "boulevard"},
                                                                    {"dr", "drive"},
                                                                    {"rd", "road"},
                                                                    {"ctr", "center"},
                                                                    {"centre", "center"},
                                                                    {"theatre", "theater"},
                                                                    {"@", "at"},
                                                                    {"&", "and"},
                                                                    {"n", "north"},
                                                                    {"s", "south"},
                                                                    {"e", "east"},
                                                                    {"w", "west"},
                                                                    {"bldg", "building"},
                                                                    {"univ", "university"},
                                                                    {"eatery", "restaurant"},
                                                                    {"pub", "bar"},
                                                                    {"clothing", "clothe"},
                                                                    {"supermarket", "grocery"},
                                                                    {"drugstore", "pharmacy"}};
  const auto it = same.find(word);
  return it == same.end() ? word : it->second;
}

std::string without_accents(const std::string& text) {
  // The second byte of U+00C0 … U+00FF in UTF-8, from 0x80; '?' is not a letter with an accent.
  constexpr std::string_view plain = "AAAAAA?CEEEEIIII?NOOOOO?OUUUUY??aaaaaa?ceeeeiiii?nooooo?ouuuuy?y";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    if (static_cast<unsigned char>(text[i]) == 0xC3 && next >= 0x80 && next < 0xC0 && plain[next - 0x80] != '?') {
      out += plain[next - 0x80];
      ++i;
    } else {
      out += text[i];
    }
  }
  return out;
}

bool is_joint(std::string_view word) { return is_among(joints, word); }
bool is_general_noun(std::string_view word) { return is_among(general, word); }
bool is_word_of_commands(std::string_view word) { return is_among(command_words, word); }

CityWords::CityWords(const std::vector<Landmark>& landmarks) {
  for (const Landmark& landmark : landmarks) {
    Names names = names_of(landmark);
    for (const auto* words : {&names.name_words, &names.tag_words})
      for (const std::string& word : *words) holders_[word].insert(names_.size());
    names_.push_back(std::move(names));
  }
}

double CityWords::rarity(const std::string& word) const {
  const auto it = holders_.find(word);
  if (it == holders_.end()) return 0;
  if (names_.size() < 2) return 1;
  return 1 - std::log(static_cast<double>(it->second.size())) / std::log(static_cast<double>(names_.size()) + 1);
}

const std::set<std::size_t>& CityWords::holders(const std::string& word) const {
  static const std::set<std::size_t> none;
  const auto it = holders_.find(word);
  return it == holders_.end() ? none : it->second;
}

std::optional<std::string> CityWords::meant(const std::string& word) const {
  if (word.size() < 6 || knows(word) || is_word_of_commands(word)) return std::nullopt;
  for (const auto& [other, _] : holders_)
    if (other.size() >= 5 && is_misspelled(word, other)) return other;
  return std::nullopt;
}

}  // namespace waymark::parser
