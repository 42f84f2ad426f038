// The words that may name the landmarks of a city: names, parts of names, and tags.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libparser/domain/commands/landmark.hpp"

namespace waymark::parser {

// Singular, abbreviations written out: "Ave" is "avenue".
std::string word_root(std::string word);
std::string without_accents(const std::string& text);  // "Café" is "Cafe", for letters of Latin-1
bool is_joint(std::string_view word);             // "operated", "on", "the": joins the words of a name or description
bool is_general_noun(std::string_view word);      // "building": says no more than that something stands there
bool is_word_of_commands(std::string_view word);  // "avoid", "then": rarely a part of a name

enum class WordMatch : std::uint8_t {  // how a word of a text stands for a word of a name
  Same,                                // it is that word
  Form,                                // a form of it: "running" for "runs", "two" for "2"
  State,                               // it says the same of a thing: "shut" for "closed"
  Opposite,                            // it says the opposite: "open" for "closed"
  Synonym,                             // a noun that means the same
  Short,                               // an abbreviation
  Misspelled,                          // some letters are wrong
};
struct WordMeaning {                  // what a word may stand for
  std::string word;                   // of a name or tag
  WordMatch match = WordMatch::Same;  // how it stands for that word
};

class CityWords {
 public:
  struct Names {                                      // of one landmark
    bool described = false;                           // its name is written small: "the bookstore", "the door is open"
    bool clause = false;                              // the name is a clause: "the door is open"
    bool untagged = false;                            // nothing but names is known: weighed as a description
    std::vector<std::set<std::string>> words;         // of each name, without joints
    std::vector<std::vector<std::string>> sequences;  // the same in their order, with the joints
    std::size_t own = 0;                              // the first sequences; the others name its brand or operator
    std::set<std::string> name_words, tag_words;      // of all
    std::set<std::string> particles;                  // joints that count: "on" of "the heater is on"
    std::string first, last;                          // of the words of a description
  };

  explicit CityWords(const std::vector<Landmark>& landmarks);

  std::size_t landmarks() const { return names_.size(); }                      // of the city
  const Names& names(std::size_t landmark) const { return names_[landmark]; }  // of one landmark
  // 1 for a word of one landmark alone, falling to 0 for a word of all (inverse frequency).
  double rarity(const std::string& word) const;
  bool knows(const std::string& word) const { return holders_.contains(word); }
  // The landmarks whose names or tags have the word; none when no landmark does.
  const std::set<std::size_t>& holders(const std::string& word) const;
  // The known word, of five letters or more, that this one misspells by one letter: from six letters on; for a word
  // of a description from five on, or from four on where a letter is missing.
  std::optional<std::string> meant(const std::string& word) const;
  // Words that a root may stand for by its form or by what it says of a state: of descriptions, and of all names when
  // the root is unknown. Those that it shortens, when it is unknown and they are few.
  std::vector<WordMeaning> meanings(const std::string& root) const;

 private:
  void index(const Names& names);
  void add_forms(const std::string& root, std::vector<WordMeaning>& out) const;
  void add_states(const std::string& root, std::vector<WordMeaning>& out) const;
  void add_short(const std::string& root, std::vector<WordMeaning>& out) const;

  std::vector<Names> names_;
  std::map<std::string, std::set<std::size_t>> holders_;
  std::set<std::string> described_;                 // words of descriptions
  std::multimap<std::string, std::string> bases_;   // base form → word
  std::multimap<std::string, WordMeaning> states_;  // base form of a related word → word of a description
};

}  // namespace waymark::parser
