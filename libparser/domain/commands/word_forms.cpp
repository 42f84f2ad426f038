#include "libparser/domain/commands/word_forms.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace waymark::parser {
namespace {

using WordSet = std::set<std::string_view>;

bool is_consonant(char c) {
  return c >= 'a' && c <= 'z' && std::string_view("aeiouy").find(c) == std::string_view::npos;
}

// The letters of "runn-ing" are those of "run".
std::string_view without_doubling(std::string_view ending, char last) {
  return ending.size() > 2 && ending[0] == last && is_consonant(last) ? ending.substr(1) : ending;
}

bool is_inflection(std::string_view ending) {
  static const WordSet endings{"",   "e",   "s",   "es",   "ed", "d",  "ing", "y",
                               "ie", "ies", "ied", "ying", "er", "en", "n",   "in"};
  return endings.contains(ending);
}
bool is_derivation(std::string_view ending) {
  static const WordSet endings{"ion",  "tion", "ation", "ication", "al",   "ment", "ure",
                               "ance", "ence", "ness",  "or",      "able", "ive",  "ity"};
  return endings.contains(ending);
}

}  // namespace

std::string base_form(const std::string& word) {
  static const std::map<std::string_view, std::string_view> bases{
      {"ate", "eat"},       {"began", "begin"},    {"begun", "begin"},
      {"bought", "buy"},    {"broke", "break"},    {"broken", "break"},
      {"brought", "bring"}, {"built", "build"},    {"came", "come"},
      {"caught", "catch"},  {"chose", "choose"},   {"chosen", "choose"},
      {"drank", "drink"},   {"driven", "drive"},   {"drove", "drive"},
      {"eaten", "eat"},     {"entrance", "enter"}, {"entry", "enter"},
      {"fallen", "fall"},   {"fed", "feed"},       {"fell", "fall"},
      {"felt", "feel"},     {"flew", "fly"},       {"flie", "fly"},
      {"flight", "fly"},    {"flown", "fly"},      {"froze", "freeze"},
      {"frozen", "freeze"}, {"gave", "give"},      {"given", "give"},
      {"goe", "go"},        {"gone", "go"},        {"grew", "grow"},
      {"grown", "grow"},    {"heard", "hear"},     {"held", "hold"},
      {"hid", "hide"},      {"hidden", "hide"},    {"kept", "keep"},
      {"laid", "lay"},      {"led", "lead"},       {"lit", "light"},
      {"loss", "lose"},     {"lost", "lose"},      {"made", "make"},
      {"met", "meet"},      {"paid", "pay"},       {"ran", "run"},
      {"rang", "ring"},     {"risen", "rise"},     {"rose", "rise"},
      {"rung", "ring"},     {"sang", "sing"},      {"sank", "sink"},
      {"sat", "sit"},       {"saw", "see"},        {"seen", "see"},
      {"sent", "send"},     {"shone", "shine"},    {"sight", "see"},
      {"slept", "sleep"},   {"sold", "sell"},      {"spoke", "speak"},
      {"spoken", "speak"},  {"stole", "steal"},    {"stolen", "steal"},
      {"stood", "stand"},   {"stuck", "stick"},    {"sunk", "sink"},
      {"swam", "swim"},     {"swept", "sweep"},    {"taken", "take"},
      {"threw", "throw"},   {"thrown", "throw"},   {"took", "take"},
      {"tore", "tear"},     {"torn", "tear"},      {"transmission", "transmit"},
      {"went", "go"},       {"woke", "wake"},      {"woken", "wake"},
      {"won", "win"},       {"written", "write"},  {"wrote", "write"}};
  const auto it = bases.find(word);
  return it == bases.end() ? word : std::string(it->second);
}

bool same_family(std::string_view a, std::string_view b) {
  if (a == b) return true;
  const std::size_t shared =
      static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
  if (shared < 3) return false;
  const char last = a[shared - 1];
  std::string_view left = without_doubling(a.substr(shared), last), right = without_doubling(b.substr(shared), last);
  if (left.size() > right.size()) std::swap(left, right);
  if (left.empty() && (right == "e" || right == "y" || right == "ie" || (right == "d" && last != 'e'))) return false;
  if (shared < 4 && (right == "er" || right == "en" || right == "n" || right == "in")) return false;
  if (left.empty() && shared < 5 && right == "er") return false;
  const auto is_y = [](std::string_view ending) { return ending == "y" || ending == "ied" || ending == "ying"; };
  if ((left == "ie" && !is_y(right)) || (right == "ie" && !is_y(left))) return false;  // "movie", "move"
  const auto fits = [&](std::string_view ending) {
    return is_inflection(ending) || (shared >= 4 && is_derivation(ending));
  };
  return fits(left) && fits(right);
}

std::optional<std::string> without_negation(const std::string& word) {
  for (const std::string_view prefix : {"un", "non", "dis", "de", "in"})
    if (word.size() >= prefix.size() + 3 && word.starts_with(prefix)) return word.substr(prefix.size());
  return std::nullopt;
}

bool is_short_form(std::string_view word, std::string_view meant) {
  if (word.size() < 2 || meant.size() < word.size() + 2 || word[0] != meant[0]) return false;
  if (word.size() >= 3 && meant.starts_with(word)) return true;
  if (word.size() > 4 || !std::all_of(word.begin(), word.end(), is_consonant)) return false;
  std::size_t met = 0;
  for (const char c : meant)
    if (met < word.size() && c == word[met]) ++met;
  return met == word.size();
}

bool is_function_word(std::string_view word) {
  static const WordSet words{
      "about",   "again",  "all",     "along",   "also",     "although", "any",     "around",   "away",       "because",
      "below",   "both",   "but",     "could",   "down",     "during",   "each",    "either",   "else",       "end",
      "even",    "ever",   "every",   "exactly", "few",      "get",      "give",    "had",      "have",       "he",
      "hence",   "her",    "here",    "him",     "his",      "how",      "however", "i",        "into",       "just",
      "keep",    "later",  "least",   "less",    "let",      "like",     "long",    "made",     "make",       "many",
      "may",     "me",     "might",   "moment",  "more",     "most",     "much",    "my",       "need",       "neither",
      "nor",     "now",    "off",     "ok",      "onto",     "other",    "others",  "our",      "out",        "over",
      "own",     "past",   "per",     "please",  "point",    "put",      "right",   "same",     "see",        "shall",
      "she",     "should", "since",   "so",      "some",     "soon",     "step",    "still",    "such",       "sure",
      "take",    "than",   "thank",   "thanks",  "their",    "them",     "there",   "these",    "they",       "thing",
      "this",    "those",  "through", "time",    "together", "too",      "under",   "unless",   "up",         "upon",
      "us",      "very",   "want",    "was",     "we",       "were",     "what",    "when",     "whenever",   "where",
      "whether", "while",  "who",     "whose",   "why",      "will",     "within",  "without",  "would",      "yes",
      "yet",     "you",    "first",   "second",  "third",    "never",    "always",  "sometime", "eventually", "once",
      "twice",   "until",  "after",   "before",  "whatever", "another",  "between", "across",   "towards",    "toward",
      "start",   "course", "order",   "state",   "holds",    "hold",     "instant", "u",        "ur",         "pls",
      "plz",     "mr",     "mrs",     "ms",      "dr",       "vs",       "tv",      "pm",       "am",         "km",
      "rest"};
  return words.contains(word) || is_light_word(word) || negates(word);
}

bool is_light_word(std::string_view word) {
  static const WordSet words{
      "be",       "been",    "being",  "is",      "are",   "was",    "were",    "am",     "has",
      "have",     "had",     "having", "get",     "gets",  "got",    "getting", "become", "becomes",
      "becoming", "became",  "go",     "goes",    "going", "come",   "comes",   "coming", "stay",
      "stays",    "staying", "remain", "remains", "keep",  "keeps",  "stand",   "stands", "shall",
      "should",   "must",    "may",    "can",     "could", "will",   "would",   "might",  "do",
      "does",     "did",     "to",     "it",      "its",   "his",    "her",     "their",  "your",
      "that",     "which",   "there",  "this",    "any",   "yet",    "too",     "very",   "still",
      "already",  "some",    "happen", "happens", "ever",  "surely", "one",     "they",   "ve",
      "needs",    "need",    "gotta",  "gonna",   "state", "bein",   "beeing",  "stay",   "presence"};
  return words.contains(word);
}

bool negates(std::string_view word) {
  static const WordSet words{"no",      "not",    "n't",    "non",      "without", "isnt",    "arent",
                             "wasnt",   "dont",   "doesnt", "didnt",    "hasnt",   "havent",  "wont",
                             "cant",    "cannot", "mustnt", "shouldnt", "nobody",  "nothing", "none",
                             "absence", "lack",   "lacks",  "nor"};
  return words.contains(word);
}

}  // namespace waymark::parser
