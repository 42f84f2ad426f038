// Word vectors of a few words, and their bytes.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "libparser/lexicon/word_vectors.hpp"
#include "libparser/lifted/lifted_reader.hpp"

namespace waymark::parser {

// words.waymark with these words, in ascending order; entry i of word r is 7 r + i modulo 19, less 9, its scale 1/8.
inline std::string bytes_of_vectors(const std::vector<std::string>& words) {
  std::string bytes = "waymark words 1\n", text;
  const auto number = [&](std::uint32_t n) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(n >> (8 * k) & 0xFFU);
  };
  number(static_cast<std::uint32_t>(words.size()));
  number(WordVectors::dimensions);
  for (const std::string& word : words) number(static_cast<std::uint32_t>((text += word).size()));
  text.resize((text.size() + 3) / 4 * 4);
  bytes += text;
  for (std::size_t r = 0; r < words.size(); ++r) number(0x3E000000);  // 1/8 in float32
  for (std::size_t r = 0; r < words.size(); ++r)
    for (std::size_t i = 0; i < WordVectors::dimensions; ++i)
      bytes += static_cast<char>(static_cast<int>((7 * r + i) % 19) - 9);
  return bytes;
}

inline std::shared_ptr<const WordVectors> few_vectors() {
  auto owner = std::make_shared<const MappedFile>(
      std::string_view(bytes_of_vectors({"and", "avoid", "go", "never", "then", "to", "walk"})));
  return WordVectors::shared(owner, owner->bytes());
}

}  // namespace waymark::parser
