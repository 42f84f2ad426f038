// The words that may name the landmarks of a city: names, parts of names, and tags.
#pragma once
#include <cstddef>
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

class CityWords {
 public:
  struct Names {                                      // of one landmark
    std::vector<std::set<std::string>> words;         // of each name, without joints
    std::vector<std::vector<std::string>> sequences;  // the same in their order, with the joints
    std::size_t own = 0;                              // the first sequences; the others name its brand or operator
    std::set<std::string> name_words, tag_words;      // of all
  };

  explicit CityWords(const std::vector<Landmark>& landmarks);

  std::size_t landmarks() const { return names_.size(); }                      // of the city
  const Names& names(std::size_t landmark) const { return names_[landmark]; }  // of one landmark
  // 1 for a word of one landmark alone, falling to 0 for a word of all (inverse frequency).
  double rarity(const std::string& word) const;
  bool knows(const std::string& word) const { return holders_.contains(word); }
  // The landmarks whose names or tags have the word; none when no landmark does.
  const std::set<std::size_t>& holders(const std::string& word) const;
  // The known word that this one misspells by one letter; only for words of six letters or more.
  std::optional<std::string> meant(const std::string& word) const;

 private:
  std::vector<Names> names_;
  std::map<std::string, std::set<std::size_t>> holders_;
};

}  // namespace waymark::parser
