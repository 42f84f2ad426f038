// Landmarks that a text names, lifted out of it: what is left of the text never says in which city it was written.
//
// Writers misspell names, shorten them and write them together or apart, so a stretch of words is compared with every
// part of every name, letter by letter with white space and accents left out, and may be off by a letter in four. The
// best covering of the text by such stretches is taken; a stretch that fits several names ("the statue") keeps them
// all. Words that people use in every city ("east", "start") name nothing by themselves.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "libparser/domain/streets/street_corpus.hpp"

namespace waymark::streets {

using CommonWords = std::unordered_set<std::string>;  // words that are no part of a name
// Words of instruction texts that are frequent in two cities without being part of a name there.
CommonWords common_words(std::span<const StreetInstruction* const> instructions, const std::vector<StreetMap>& maps);

struct NameFit {               // how a stretch of words fits a name
  LandmarkIndex landmark = 0;  // whose name it is
  float letters = 0;           // matched, less two for every slip
  float complete = 0;          // of the name, in [0, 1]
};

struct Mention {
  std::size_t begin = 0, end = 0;  // words of the text
  std::vector<NameFit> fits;       // best first, at least one
};

class MentionFinder {  // of one map
 public:
  MentionFinder(const StreetMap& map, const CommonWords& common);
  // In the order of the text, disjoint. Keeps what it has compared, for texts repeat themselves.
  std::vector<Mention> find(const std::vector<std::string>& tokens);

 private:
  struct NamePart {
    LandmarkIndex landmark;
    std::string letters;
    std::size_t name_letters;  // of the whole name
    bool common;               // says nothing by itself
  };
  void add_parts(LandmarkIndex landmark, const std::vector<std::string>& words);
  const std::vector<NameFit>& fits(const std::string& letters, bool common);

  const CommonWords& common_;
  std::vector<NamePart> parts_;
  std::size_t most_words_ = 0;  // of a stretch
  std::unordered_map<std::string, std::vector<NameFit>> known_[2];
};

// Lower case, accents and whatever is neither letter nor digit left out: "Così" → "cosi".
std::string letters_of(std::string_view word);
// Insertions, deletions, replacements, and exchanges of neighbours that turn one into the other [Dam64].
std::size_t slips(std::string_view a, std::string_view b);

}  // namespace waymark::streets
