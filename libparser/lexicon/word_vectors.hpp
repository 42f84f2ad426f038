// Vectors of English words, GloVe [PSM14] in eight bits an entry: words used alike have vectors that are close.
//
// Words are looked up in the bytes of the file, by binary search. Layout of the file: docs/formats/lifted.md.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace waymark::parser {

class WordVectors {
 public:
  static constexpr std::size_t dimensions = 100;  // of each vector

  // The bytes must outlive the vectors. Throws ltl::FormatError when they are no vectors, or cut short.
  explicit WordVectors(std::string_view bytes, std::string_view source = "");
  // The owner of the bytes lives as long as the vectors do.
  static std::shared_ptr<const WordVectors> shared(std::shared_ptr<const void> owner, std::string_view bytes,
                                                   std::string_view source = "");

  std::string_view bytes() const { return bytes_; }  // the whole file
  std::size_t size() const { return ends_.size(); }
  std::optional<std::size_t> find(std::string_view word) const;  // its row, in O(log size)
  std::string_view word(std::size_t row) const;                  // row < size()
  // entries of the vector of a row: scale(row) * entries(row)[i]
  float scale(std::size_t row) const { return scales_[row]; }
  std::span<const std::int8_t> entries(std::size_t row) const { return entries_.subspan(row * dimensions, dimensions); }

  // The cosine of the angle between two vectors.
  double similarity(std::size_t a, std::size_t b) const;

 private:
  std::span<const std::uint32_t> ends_;
  std::string_view bytes_, words_;
  std::span<const float> scales_;
  std::span<const std::int8_t> entries_;
};

}  // namespace waymark::parser
