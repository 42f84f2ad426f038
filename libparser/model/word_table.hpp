// The words that a model knows, by number.
#pragma once
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace waymark::parser {

struct WordId {             // a word of one table
  std::uint32_t index = 0;  // its number
  friend auto operator<=>(const WordId&, const WordId&) = default;
};

class WordTable {
 public:
  static constexpr WordId unknown{0}, begin{1}, end{2};  // of a sentence; ordinary words from 3 on
  WordTable();
  WordId find(std::string_view word) const;                         // `unknown` when it is not in the table
  WordId add(std::string_view word);                                // its number, new or not
  const std::vector<std::string>& words() const { return words_; }  // by number

 private:
  std::vector<std::string> words_;
  std::unordered_map<std::string, WordId> index_;
};

}  // namespace waymark::parser
