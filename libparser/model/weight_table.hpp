// Features → rows of weights, as they are learned (WeightTable) and as they lie in a model file (StoredRows).
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "libparser/model/mapped_file.hpp"

namespace waymark::parser {

// Numbers in groups of seven bits, the lowest first, all but the last with the high bit set (LEB128).
inline std::uint64_t take_leb128(const char*& at) {
  std::uint64_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const auto byte = static_cast<unsigned char>(*at++);
    value |= std::uint64_t{byte & 0x7FU} << shift;
    if (byte < 0x80U) return value;
  }
}

std::uint16_t half_of(float value);  // binary16, rounded to nearest; magnitudes beyond 65,504 saturate
float float_of(std::uint16_t half);  // exact

// Rows by ascending feature, in blocks of sixteen; layout: docs/formats/corpus-and-models.md. Looked up where they lie.
// What it is given must have been checked (WeightsReader::table).
struct StoredRows {
  static constexpr std::size_t block = 16;  // rows of a block
  std::shared_ptr<const MappedFile> file;   // that holds the rows
  std::size_t rows = 0;                     // how many
  std::span<const std::uint64_t> last;      // of each block: its last feature
  std::span<const std::uint32_t> end;       // of each block: where its bytes end
  std::string_view bytes;                   // of the rows
};

// A row of one table: its number while the table is learned, else where its weights begin among the bytes.
struct WeightRow {
  std::uint32_t index = 0;  // in the table
  friend bool operator==(WeightRow, WeightRow) = default;
};

// While it is learned a table is dense. One of a model file cannot be learned further.
class WeightTable {
 public:
  explicit WeightTable(std::size_t columns) : columns_(columns) {}
  WeightTable(std::size_t columns, StoredRows stored) : columns_(columns), stored_(std::move(stored)) {}

  std::size_t columns() const { return columns_; }                                // weights of a row
  std::size_t rows() const { return is_stored() ? stored_.rows : keys_.size(); }  // how many
  std::optional<WeightRow> find(std::uint64_t feature) const;                     // O(log rows) when stored
  // The same. `near` is where the last search ended, at first 0: features in ascending order are found sooner.
  std::optional<WeightRow> find(std::uint64_t feature, std::size_t& near) const;
  WeightRow add(std::uint64_t feature);  // learned tables alone; a new row is zero
  // columns() floats of a learned table, whose rows are numbered in the order of their first use.
  float* row(WeightRow r) { return weights_.data() + r.index * columns_; }

  float weight(WeightRow r, std::size_t column) const;  // as it is stored
  void add_to(WeightRow r, float* sums) const;          // sums: [columns()]
  // visit(feature, column, weight) for every weight that is not zero.
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::uint32_t r = 0; r < keys_.size(); ++r)
      for (std::size_t c = 0; c < columns_; ++c)
        if (const float w = weights_[r * columns_ + c]; w != 0) visit(keys_[r], c, w);
    const char* at = stored_.bytes.data();
    std::uint64_t feature = 0;
    for (std::size_t r = 0; r < stored_.rows; ++r) {
      feature += take_leb128(at);
      at = each_weight(at, [&](std::size_t c, std::uint16_t half) {
        if (const float w = float_of(half); w != 0) visit(feature, c, w);
      });
    }
  }

 private:
  static constexpr std::uint32_t empty = UINT32_MAX;  // of a slot
  bool is_stored() const { return stored_.file != nullptr; }
  // visit(column, half) for the weights of the stored row behind its feature; returns where the next row begins.
  template <class Visit>
  const char* each_weight(const char* at, const Visit& visit) const {
    std::size_t column = 0;
    for (std::uint64_t left = columns_ > 1 ? take_leb128(at) : 1; left > 0; --left, ++column) {
      if (columns_ > 1) column += take_leb128(at);
      std::uint16_t half = 0;
      std::memcpy(&half, at, sizeof half);
      at += sizeof half;
      visit(column, half);
    }
    return at;
  }
  std::optional<WeightRow> find_stored(std::uint64_t feature, std::size_t& near) const;
  std::size_t slot_of(std::uint64_t feature) const;

  std::size_t columns_;
  std::vector<std::uint64_t> keys_;
  std::vector<float> weights_;                                                // [rows][columns]
  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(64, empty);  // open addressing, 2ᵏ slots
  StoredRows stored_;
};

}  // namespace waymark::parser
