#include "libparser/lexicon/lexicon.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>

namespace waymark::parser {
namespace {

struct Entry {
  const char* thing;
  std::array<const char*, 8> words;  // one or two words each
};

constexpr Entry entries[] = {
    {"barstool", {"barstool", "stool", "bar stool"}},
    {"chair", {"chair", "armchair"}},
    {"easel", {"easel"}},
    {"hatrack", {"hatrack", "hat rack", "coatrack", "coat rack", "rack"}},
    {"lamp", {"lamp", "light"}},
    {"sofa", {"sofa", "couch", "bench"}},
    {"blue", {"blue"}},
    {"brick", {"brick", "red"}},
    {"concrete", {"concrete", "cement", "grey", "gray", "plain", "bare"}},
    {"flower", {"flower", "flowered", "floral", "rose", "pink"}},
    {"grass", {"grass", "grassy", "green"}},
    {"gravel", {"gravel", "stone", "black"}},
    {"wood", {"wood", "wooden", "brown"}},
    {"yellow", {"yellow", "octagon", "honeycomb", "hexagon"}},
    {"butterfly", {"butterfly", "butterflie"}},
    {"fish", {"fish", "fishe"}},
    {"tower", {"tower", "eiffel"}},
    {"wall", {"wall"}},
    {"intersection", {"intersection", "junction", "crossing", "crossroad"}},
    {"corner", {"corner"}},
    {"tee", {"tee", "t", "t-intersection", "t-junction"}},
    {"dead_end", {"dead end", "dead-end"}},
    {"left", {"left", "lefthand"}},
    {"right", {"right", "righthand"}},
};

void singular(std::string& word) {
  if (word.size() > 3 && word.back() == 's' && word[word.size() - 2] != 's') word.pop_back();
}

// The words, the parts of words with hyphens, and pairs of neighbours; plural endings dropped.
std::vector<std::string> phrases(const std::vector<std::string>& tokens) {
  std::vector<std::string> out;
  std::string before;
  for (std::string word : tokens) {
    singular(word);
    out.push_back(word);
    if (!before.empty()) out.push_back(before + " " + word);
    before = word;
    for (std::size_t begin = 0; word.find('-') != std::string::npos && begin <= word.size();) {
      const std::size_t end = std::min(word.find('-', begin), word.size());
      std::string part = word.substr(begin, end - begin);
      singular(part);
      if (part.size() > 1) out.push_back(std::move(part));
      begin = end + 1;
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

Part thing(std::string name) { return {PartKind::Thing, std::move(name), 0}; }
Part count(std::size_t number) { return {PartKind::Count, std::to_string(number), number}; }

std::vector<Part> mentions(const std::vector<std::string>& tokens) {
  const std::vector<std::string> said = phrases(tokens);
  std::vector<Part> out;
  for (const Entry& entry : entries)
    for (const char* word : entry.words)
      if (word != nullptr && std::binary_search(said.begin(), said.end(), word)) out.push_back(thing(entry.thing));
  for (const std::string& word : tokens)
    if (const std::size_t n = number_named(word); n > 0) {
      out.push_back(count(n));
      out.push_back(thing(std::to_string(n)));
    }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<std::string> other_names(const std::string& thing) {
  std::vector<std::string> out;
  for (const Entry& entry : entries)
    for (const char* word : entry.words)
      if (word != nullptr && thing == entry.thing) out.emplace_back(word);
  return out;
}

bool in_lexicon(const Part& part) {
  if (part.kind == PartKind::Count) return part.number != 1;
  return part.kind == PartKind::Thing &&
         std::any_of(std::begin(entries), std::end(entries), [&](const Entry& e) { return part.name == e.thing; });
}

std::size_t number_named(const std::string& word) {
  constexpr std::array<const char*, 13> names{"zero",  "one",   "two",  "three", "four",  "five",  "six",
                                              "seven", "eight", "nine", "once",  "twice", "thrice"};
  for (std::size_t n = 1; n < names.size(); ++n)
    if (word == names[n]) return n < 10 ? n : n - 9;
  std::size_t n = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
  return error == std::errc() && end == word.data() + word.size() && n < 1000 ? n : 0;
}

}  // namespace waymark::parser
