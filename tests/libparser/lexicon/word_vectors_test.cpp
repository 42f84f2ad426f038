#include "libparser/lexicon/word_vectors.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "libparser/model/mapped_file.hpp"
#include "libparser/model/whole_file.hpp"
#include "tests/libparser/lifted/few_words.hpp"

namespace waymark::parser {
namespace {

const std::vector<std::string> words{"a", "chair", "lamp", "lamps", "zebra"};

TEST(WordVectors, FindTheWordsThatAreThereAndNoOthers) {
  const MappedFile file{std::string_view(bytes_of_vectors(words))};
  const WordVectors vectors(file.bytes());
  ASSERT_EQ(vectors.size(), words.size());
  for (std::size_t r = 0; r < words.size(); ++r) {
    EXPECT_EQ(vectors.find(words[r]), r);
    EXPECT_EQ(vectors.word(r), words[r]);
    EXPECT_EQ(vectors.scale(r), 0.125F);
    EXPECT_EQ(vectors.entries(r)[3], static_cast<int>((7 * r + 3) % 19) - 9);
    EXPECT_NEAR(vectors.similarity(r, r), 1, 1e-12);
  }
  for (const char* other : {"", "b", "lam", "lampss", "zzz"}) EXPECT_FALSE(vectors.find(other)) << other;
  EXPECT_LT(vectors.similarity(0, 1), 1);
}

TEST(WordVectors, EveryCutIsNoticed) {
  const MappedFile file{std::string_view(bytes_of_vectors(words))};
  for (std::size_t n = 0; n < file.bytes().size(); ++n)
    EXPECT_THROW(WordVectors(file.bytes().substr(0, n)), ltl::FormatError) << n;
}

TEST(WordVectors, WhatStandsBehindThemIsNoticed) {
  const MappedFile file{std::string_view(bytes_of_vectors(words) + "tail")};
  EXPECT_THROW(WordVectors(file.bytes()), ltl::FormatError);
}

TEST(WordVectors, ScalesAreFinite) {
  std::string bytes = bytes_of_vectors(words);
  bytes.replace(24 + 4 * 5 + 20, 4, std::string_view("\0\0\x80\x7F", 4));  // behind head, ends and text: ∞
  const MappedFile file{std::string_view(bytes)};
  EXPECT_THROW(WordVectors(file.bytes()), ltl::FormatError);
}

TEST(WordVectors, DamagedHeadsAreRefused) {
  const auto message = [](std::size_t at, char byte) -> std::string {
    std::string bytes = bytes_of_vectors(words);
    bytes[at] = byte;
    const MappedFile file{std::string_view(bytes)};
    try {
      WordVectors vectors(file.bytes(), "w");
    } catch (const ltl::FormatError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(14, '2').find("version 1"), std::string::npos);
  EXPECT_NE(message(20, 99).find("length"), std::string::npos);
  EXPECT_NE(message(24 + 4, 0).find("damaged"), std::string::npos);                 // a word that ends before it begins
  EXPECT_NE(message(24 + 4 * 4 + 3, '\xFF').find("cut short"), std::string::npos);  // ends near 2³²
}

// The file of these bytes as the reader of commands loads it: the bytes of its vectors, or nothing where it is refused.
std::optional<std::string> loaded(const std::string& bytes) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "word_vectors_test.waymark";
  write_file(file, bytes);
  std::optional<std::string> out;
  try {
    out = LiftedReader::load_vectors(file)->bytes();
  } catch (const ltl::FormatError&) {
  }
  std::filesystem::remove(file);
  return out;
}

TEST(WordVectors, OfASealedFileAreRefusedWhereAnyByteIsAnother) {
  const std::string bare = bytes_of_vectors(words);
  std::string seal = "checksum";
  for (std::uint64_t sum = ltl::xxh64(bare), k = 0; k < 8; ++k, sum >>= 8U) seal += static_cast<char>(sum & 0xFFU);
  const std::string whole = bare + seal;
  EXPECT_EQ(loaded(bare), bare);
  EXPECT_EQ(loaded(whole), bare);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    EXPECT_FALSE(loaded(damaged)) << at;
    EXPECT_EQ(loaded(whole.substr(0, at)).has_value(), at == bare.size()) << at;
  }
  EXPECT_FALSE(loaded(whole + "checksum"));
}

TEST(WordVectors, OfTheShippedFileKnowWhatIsAlike) {
  const auto shared = LiftedReader::load_vectors(WAYMARK_SOURCE_DIR "/data/words/words.waymark");
  const WordVectors& vectors = *shared;
  EXPECT_GT(vectors.size(), 20'000U);
  const auto alike = [&](const char* a, const char* b) {
    return vectors.similarity(*vectors.find(a), *vectors.find(b));
  };
  EXPECT_GT(alike("couch", "sofa"), alike("couch", "never"));
  EXPECT_GT(alike("avoid", "prevent"), alike("avoid", "lamp"));
}

}  // namespace
}  // namespace waymark::parser
