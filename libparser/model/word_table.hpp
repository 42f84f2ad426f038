// The words that a model knows, by number.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace waymark::parser {

class WordTable {
 public:
  static constexpr std::uint32_t unknown = 0, begin = 1, end = 2;  // of a sentence; ordinary words from 3 on
  WordTable();
  std::uint32_t find(std::string_view word) const;  // `unknown` when it is not in the table
  std::uint32_t add(std::string_view word);
  const std::vector<std::string>& words() const { return words_; }

 private:
  std::vector<std::string> words_;
  std::unordered_map<std::string, std::uint32_t> index_;
};

}  // namespace waymark::parser
