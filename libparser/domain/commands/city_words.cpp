#include "libparser/domain/commands/city_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/states.hpp"
#include "libparser/domain/commands/word_forms.hpp"
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
  constexpr std::string_view possessive = "possessive";  // the "s" of "Mary's", which is no "south"
  for (std::size_t at = 0; (at = plain.find("'s", at)) != std::string::npos; ++at)
    if (at + 2 == plain.size() || plain[at + 2] == ' ') plain.replace(at, 2, ' ' + std::string(possessive));
  std::vector<std::string> out;
  for (std::string& token : tokenize(plain)) out.push_back(token == possessive ? "s" : word_root(std::move(token)));
  return out;
}

void add_name(CityWords::Names& names, const std::string& name) {
  std::set<std::string> words;
  names.sequences.push_back(roots(name));
  for (const std::string& word : names.sequences.back())
    if ((!is_joint(word) || names.particles.contains(word)) && word.find_first_of(",.;:!?'\"()") == std::string::npos)
      words.insert(word);
  names.name_words.insert(words.begin(), words.end());
  if (!words.empty()) names.words.push_back(std::move(words));
}

bool is_copula(const std::string& word) { return word == "is" || word == "are" || word == "be" || word == "ha"; }

// What a name that is written small describes: "the pump runs" is a clause, "the parking garage" is none.
void describe(CityWords::Names& names, const std::string& name) {
  names.described = std::none_of(name.begin(), name.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  if (!names.described) return;
  const std::vector<std::string> plain = tokenize(name), words = roots(name);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_verb = i > 0 && i < plain.size() && plain[i].size() > 3 && plain[i].back() == 's' &&
                         plain[i] != words[i] && !names.first.empty();
    if (is_copula(words[i]) || is_verb) names.clause = true;
    if (words[i] == "it" && i == 0) names.clause = true;
    if (is_joint(words[i]) && ((i > 0 && is_copula(words[i - 1])) || i + 1 == words.size()) && words[i] != "a" &&
        words[i] != "the" && words[i] != "an" && words[i] != "its" && words[i] != "s")
      names.particles.insert(words[i]);
    if (is_joint(words[i]) && !names.particles.contains(words[i])) continue;
    if (names.first.empty()) names.first = words[i];
    names.last = words[i];
  }
}

CityWords::Names names_of(const Landmark& landmark) {
  CityWords::Names out;
  describe(out, landmark.name);
  out.untagged = landmark.tags.empty();
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
    index(names);
    names_.push_back(std::move(names));
  }
  for (const auto& [word, _] : holders_) bases_.emplace(base_form(word), word);
}

void CityWords::index(const Names& names) {
  if (!names.described) return;
  for (const std::string& word : names.name_words) {
    if (!described_.insert(word).second) continue;
    for (const RelatedState& related : related_states(word))
      states_.emplace(related.word, WordMeaning{word, related.opposite ? WordMatch::Opposite : WordMatch::State});
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
  if (word.size() < 4 || knows(word) || is_joint(word) || is_word_of_commands(word) || is_function_word(word))
    return std::nullopt;
  for (const auto& [other, _] : holders_) {
    const bool described = described_.contains(other);
    if (word.size() < (described ? 5U : 6U) && !(described && other.size() > word.size())) continue;
    if (other.size() >= 5 && is_misspelled(word, other)) return other;
  }
  return std::nullopt;
}

namespace {

// Calls use(value) for each entry of an index whose base form is of the family of a word.
template <typename Index, typename Use>
void for_each_relative(const Index& index, const std::string& base, Use use) {
  constexpr std::size_t shared = 3;  // letters, of all words of a family
  if (base.size() < shared) {
    const auto [begin, end] = index.equal_range(base);
    for (auto it = begin; it != end; ++it) use(it->second);
    return;
  }
  for (auto it = index.lower_bound(base.substr(0, shared)); it != index.end(); ++it) {
    if (it->first.compare(0, shared, base, 0, shared) != 0) break;
    if (same_family(base, it->first)) use(it->second);
  }
}

// "two" and "second" are "2".
std::optional<std::string> as_number(const std::string& word) {
  constexpr std::array<std::array<std::string_view, 3>, 10> numbers{{{"one", "first", "1st"},
                                                                     {"two", "second", "2nd"},
                                                                     {"three", "third", "3rd"},
                                                                     {"four", "fourth", "4th"},
                                                                     {"five", "fifth", "5th"},
                                                                     {"six", "sixth", "6th"},
                                                                     {"seven", "seventh", "7th"},
                                                                     {"eight", "eighth", "8th"},
                                                                     {"nine", "ninth", "9th"},
                                                                     {"ten", "tenth", "10th"}}};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (is_among(numbers[i], word)) return std::to_string(i + 1);
  return std::nullopt;
}

}  // namespace

void CityWords::add_forms(const std::string& root, std::vector<WordMeaning>& out) const {
  constexpr std::size_t long_enough = 5;  // for a form of a word of a name that is written with capitals
  const bool unknown = !knows(root) && !is_function_word(root) && root.size() >= long_enough;
  for_each_relative(bases_, base_form(root), [&](const std::string& word) {
    if (word != root && (unknown || described_.contains(word))) out.push_back({word, WordMatch::Form});
  });
  if (const auto number = as_number(root); number && described_.contains(*number))
    out.push_back({*number, WordMatch::Form});
  if (const auto positive = without_negation(root))
    for_each_relative(bases_, base_form(*positive), [&](const std::string& word) {
      if (described_.contains(word)) out.push_back({word, WordMatch::Opposite});
    });
}

void CityWords::add_states(const std::string& root, std::vector<WordMeaning>& out) const {
  for_each_relative(states_, base_form(root), [&](const WordMeaning& meaning) {
    if (meaning.word != root) out.push_back(meaning);
  });
}

void CityWords::add_short(const std::string& root, std::vector<WordMeaning>& out) const {
  constexpr std::size_t most_meant = 4;
  if (knows(root) || root.empty() || is_function_word(root) || is_joint(root) || is_word_of_commands(root)) return;
  std::vector<std::string> meant;
  for (auto it = holders_.lower_bound(root.substr(0, 1)); it != holders_.end() && it->first[0] == root[0]; ++it)
    if (is_short_form(root, it->first)) meant.push_back(it->first);
  if (meant.size() > most_meant) return;
  for (std::string& word : meant) out.push_back({std::move(word), WordMatch::Short});
}

std::vector<WordMeaning> CityWords::meanings(const std::string& root) const {
  std::vector<WordMeaning> out;
  add_forms(root, out);
  add_states(root, out);
  add_short(root, out);
  return out;
}

}  // namespace waymark::parser
