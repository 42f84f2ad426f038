#include "libparser/domain/commands/landmark_mentions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "libparser/corpus/token.hpp"

namespace waymark::parser {
namespace {

// What a matched word, a joint and a foreign word inside a phrase are worth, in units of a word that fits one
// landmark alone.
constexpr double by_name = 1, by_tag = 0.75, joint = -0.02, foreign = -0.9, each_mention = -0.55, whole_name = 0.9,
                 shared_name = 0.6, in_order = 0.25, comma = -0.3,
                 adjacent = -2.5,  // to the phrase before, or joined to it by "operated by"
    misspelled = 0.8,
                 also_tag = 0.1;  // a lone word of a name that also says what the landmark is: "the library"
constexpr std::size_t longest_phrase = 14, most_readings = 4;

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
constexpr std::array<std::string_view, 26> told_tags{
    "amenity",      "cuisine",          "shop",     "building",     "leisure",
    "tourism",      "office",           "religion", "addr:street",  "addr:housenumber",
    "denomination", "operator",         "historic", "man_made",     "memorial",
    "power",        "landuse",          "natural",  "waterway",     "railway",
    "highway",      "public_transport", "sport",    "artwork_type", "healthcare",
    "brand"};
// Nouns that say no more than that something stands there.
constexpr std::array<std::string_view, 10> general{"building", "place", "store", "shop",     "location",
                                                   "site",     "area",  "spot",  "landmark", "establishment"};

std::string root(std::string word) {
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

std::vector<std::string> roots(const std::string& text) {
  std::string plain = text;
  for (char& c : plain)
    if (c == '_' || c == ';' || c == '-' || c == '/') c = ' ';
  std::vector<std::string> out;
  for (std::string& token : tokenize(plain)) out.push_back(root(std::move(token)));
  return out;
}

struct Known {
  std::vector<std::set<std::string>> names;         // words of each of the names
  std::vector<std::vector<std::string>> sequences;  // the same in their order, with the joints
  std::size_t own_names = 0;                        // the first of the sequences; the others name its brand or operator
  std::set<std::string> name_words, tag_words;
};

class City {
 public:
  explicit City(const std::vector<Landmark>& landmarks) {
    for (const Landmark& l : landmarks) {
      Known k;
      std::vector<std::string> names = l.other_names;
      names.insert(names.begin(), l.name);
      for (const char* key : {"short_name", "alt_name", "official_name", "old_name", "name:en"})
        if (const auto tag = l.tags.find(key); tag != l.tags.end()) names.push_back(tag->second);
      k.own_names = names.size();
      for (const char* key : {"brand", "operator"})
        if (const auto tag = l.tags.find(key); tag != l.tags.end()) names.push_back(tag->second);
      for (const std::string& name : names) {
        std::set<std::string> words;
        k.sequences.push_back(roots(name));
        for (const std::string& word : k.sequences.back())
          if (!is_among(joints, word) && word.find_first_of(",.;:!?'\"()") == std::string::npos) words.insert(word);
        k.name_words.insert(words.begin(), words.end());
        if (!words.empty()) k.names.push_back(std::move(words));
      }
      for (const auto& [key, value] : l.tags) {
        if (!is_among(told_tags, key) || value == "no") continue;
        for (std::string& word : roots(value == "yes" ? key : value)) k.tag_words.insert(word);
        if (key.find(':') == std::string::npos && key != "brand" && key != "operator")
          for (std::string& word : roots(key)) k.tag_words.insert(word);
      }
      for (const auto& words : {k.name_words, k.tag_words})
        for (const std::string& word : words) holders_[word].insert(known_.size());
      known_.push_back(std::move(k));
    }
  }

  std::size_t size() const { return known_.size(); }
  // 1 for a word of one landmark alone, falling to 0 for a word of all.
  double told_by(const std::string& word) const {
    const auto it = holders_.find(word);
    if (it == holders_.end() || known_.size() < 2) return it == holders_.end() ? 0 : 1;
    return 1 - std::log(static_cast<double>(it->second.size())) / std::log(static_cast<double>(known_.size()) + 1);
  }
  bool is_name_word(const std::string& word) const { return holders_.contains(word); }
  const Known& operator[](std::size_t i) const { return known_[i]; }
  // The word of a name that this one misspells.
  std::optional<std::string> meant(const std::string& word) const {
    if (word.size() < 6 || holders_.contains(word) || is_among(command_words, word)) return std::nullopt;
    for (const auto& [other, _] : holders_)
      if (other.size() >= 5 && is_misspelled(word, other)) return other;
    return std::nullopt;
  }

 private:
  std::vector<Known> known_;
  std::map<std::string, std::set<std::size_t>> holders_;
};

struct Phrase {
  std::size_t begin, end, landmark;
  double score;
};

class Finder {
 public:
  Finder(const std::vector<std::string>& tokens, const City& city) : city_(city) {
    for (const std::string& token : tokens) {
      std::string word = root(token);
      bool is_misspelled = false;
      if (const auto meant = city.meant(word)) {
        word = *meant;
        is_misspelled = true;
      }
      words_.push_back(std::move(word));
      exact_.push_back(!is_misspelled);
    }
    for (std::size_t i = 0; i + 1 < words_.size(); ++i)  // "tai pan" where a name has "taipan"
      if (city.is_name_word(words_[i] + words_[i + 1])) {
        words_[i] += words_[i + 1];
        words_[i + 1] = words_[i];
      }
  }

  double score(std::size_t begin, std::size_t end, std::size_t landmark) const {
    const Known& known = city_[landmark];
    double sum = each_mention;
    std::set<std::string> said;
    for (std::size_t i = begin; i < end; ++i) {
      const std::string& word = words_[i];
      const double sure = exact_[i] ? 1 : misspelled;
      const bool in_name = known.name_words.contains(word), in_tags = known.tag_words.contains(word);
      if (said.contains(word) && (in_name || in_tags)) {
        sum += 1e-3;
        continue;
      }
      said.insert(word);
      const double verb = is_among(command_words, word) ? 0.1 : 1;
      if (in_name && !is_among(joints, word))
        sum += sure * verb *
               (by_name * (0.35 + 0.65 * city_.told_by(word)) + (in_tags && end - begin == 1 ? also_tag : 0));
      else if (in_tags && !is_among(joints, word))
        sum += sure * verb * by_tag * (0.35 + 0.65 * city_.told_by(word));
      else if (word == ",")
        sum += comma;
      else if (is_among(joints, word) || is_among(general, word))
        sum += joint;
      else
        sum += foreign;
    }
    const auto from = words_.begin() + static_cast<std::ptrdiff_t>(begin),
               to = words_.begin() + static_cast<std::ptrdiff_t>(end);
    for (std::size_t i = 0; i < known.sequences.size(); ++i)
      if (const auto& name = known.sequences[i]; std::search(from, to, name.begin(), name.end()) != to)
        return sum + (i < known.own_names ? whole_name : shared_name) + in_order * static_cast<double>(name.size());
    for (const auto& name : known.names)
      if (std::includes(said.begin(), said.end(), name.begin(), name.end())) return sum + whole_name;
    return sum;
  }

  // The phrases of the best cover, from left to right, and what else each may name.
  std::vector<std::pair<Phrase, std::vector<Phrase>>> cover() const {
    const std::size_t n = words_.size();
    std::vector<double> best(n + 1, 0);
    std::vector<std::optional<Phrase>> taken(n + 1);
    for (std::size_t end = 1; end <= n; ++end) {
      best[end] = best[end - 1];
      if (!ends_phrase(end - 1)) continue;
      for (std::size_t begin = end; begin-- > 0 && end - begin <= longest_phrase;) {
        if (words_[begin] == ";" || (words_[begin] == "," && !describes(begin + 1))) break;
        if (!ends_phrase(begin)) continue;
        for (std::size_t l = 0; l < city_.size(); ++l)
          if (const double s = score(begin, end, l) + (follows_phrase(begin, taken) ? adjacent : 0);
              s > 0 && best[begin] + s > best[end] + 1e-9) {
            best[end] = best[begin] + s;
            taken[end] = Phrase{begin, end, l, s};
          }
      }
    }
    std::vector<std::pair<Phrase, std::vector<Phrase>>> out;
    for (std::size_t at = n; at > 0;) {
      if (!taken[at]) {
        --at;
        continue;
      }
      std::vector<Phrase> others;
      for (std::size_t l = 0; l < city_.size(); ++l)
        if (const double s = score(taken[at]->begin, at, l); l != taken[at]->landmark && s > 0)
          others.push_back({taken[at]->begin, at, l, s});
      out.emplace_back(*taken[at], std::move(others));
      at = taken[at]->begin;
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  bool follows_phrase(std::size_t at, const std::vector<std::optional<Phrase>>& taken) const {
    if (taken[at]) return true;
    constexpr std::array<std::string_view, 15> ties{"operated", "by",   "on",      "at",   "in",
                                                    "of",       "with", "located", "the",  "near",
                                                    "serving",  "west", "north",   "east", "south"};
    while (at > 0 && is_among(ties, words_[at - 1])) --at;
    if (at > 1 && (words_[at - 1] == "a" || words_[at - 1] == "an") && words_[at - 2] == ",") at -= 2;
    return at > 0 && taken[at].has_value();
  }
  // ", a theatre building": what follows a comma with an article says more of the same place.
  bool describes(std::size_t at) const {
    return at < words_.size() &&
           (words_[at] == "a" || words_[at] == "an" || words_[at] == "the" || words_[at] == "located");
  }
  bool ends_phrase(std::size_t at) const { return !is_among(joints, words_[at]) && city_.is_name_word(words_[at]); }

  const City& city_;
  std::vector<std::string> words_;
  std::vector<bool> exact_;
};

// Where a phrase ends with what is said of its place: general nouns, "on Central Avenue", ", a theatre building,".
std::size_t with_description(const std::vector<std::string>& tokens, std::size_t end) {
  constexpr std::array<std::string_view, 12> streets{"street", "avenue", "road", "lane",  "boulevard", "drive",
                                                     "plaza",  "place",  "way",  "court", "square",    "parkway"};
  constexpr std::size_t longest_description = 6;
  const auto is = [&](std::size_t at, auto... words) { return at < tokens.size() && ((tokens[at] == words) || ...); };
  while (end < tokens.size() && is_among(general, root(tokens[end]))) ++end;
  if (is(end, "on", "at", "in", "near", "along"))
    for (std::size_t at = end + 1; at < tokens.size() && at <= end + longest_description && !is(at, ",", "and", "then");
         ++at)
      if (is_among(streets, root(tokens[at]))) return at + 1;
  if (is(end, ",") && is(end + 1, "a", "an"))
    for (std::size_t at = end + 2; at <= tokens.size() && at <= end + 2 + longest_description; ++at) {
      if (at == tokens.size() || is(at, ",", ".")) return at;
      if (is(at, "then", "and", "or", "go", "visit")) break;
    }
  return end;
}

LandmarkLift lifted(const std::vector<std::string>& tokens, const std::vector<Phrase>& phrases) {
  std::vector<Mention> mentions;
  for (const Phrase& p : phrases) mentions.push_back({p.begin, p.end, p.landmark});
  LiftedMentions lifted = parser::lift(tokens, mentions);
  LandmarkLift out;
  out.text = std::move(lifted.text);
  out.slots = std::move(lifted.things);
  return out;
}

}  // namespace

std::vector<LandmarkLift> lift_landmarks(const std::string& text, const std::vector<Landmark>& landmarks) {
  constexpr double sharpness = 4;  // of the share that other landmarks get of a phrase
  const City city(landmarks);
  std::string plain = text;
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == '/' || c == '-'; }, ' ');
  const std::vector<std::string> tokens = tokenize(plain);
  const auto cover = Finder(tokens, city).cover();
  std::vector<Phrase> best;
  for (const auto& [phrase, _] : cover) best.push_back(phrase);
  for (std::size_t i = 0; i < best.size(); ++i) {
    const std::size_t end = with_description(tokens, best[i].end);
    if (i + 1 == best.size() || end <= best[i + 1].begin) best[i].end = end;
  }
  std::vector<LandmarkLift> out{lifted(tokens, best)};
  for (std::size_t i = 0; i < cover.size(); ++i)
    for (const Phrase& other : cover[i].second) {
      const double share = std::exp(sharpness * (other.score - cover[i].first.score));
      if (share < 0.05) continue;
      std::vector<Phrase> changed = best;
      changed[i] = other;
      out.push_back(lifted(tokens, changed));
      out.back().probability = share;
    }
  std::stable_sort(out.begin() + 1, out.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  if (out.size() > most_readings) out.resize(most_readings);
  double total = 0;
  for (const auto& l : out) total += l.probability;
  for (auto& l : out) l.probability /= total;
  return out;
}

}  // namespace waymark::parser
