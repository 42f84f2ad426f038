// Nouns that mean the same: synsets of WordNet [Mil95].
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

namespace waymark::parser {

class Synonyms {
 public:
  // Each group: phrases separated by ", ", as in data/words/synonyms.txt.
  explicit Synonyms(std::vector<std::string> groups = {});

  // What shares a group with the phrase, in order, without the phrase itself. O(log groups).
  std::vector<std::string> of(const std::string& phrase) const;
  std::span<const std::string> groups() const { return groups_; }

 private:
  std::vector<std::string> groups_;
  std::multimap<std::string, std::size_t> groups_of_;
};

}  // namespace waymark::parser
