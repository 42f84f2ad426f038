#include "libparser/model/weights_bytes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

constexpr std::string_view magic = "waymark\n";
constexpr std::size_t most_weights = std::size_t{1} << 25U;  // of a table, while reading

// Binary16, rounded to nearest; magnitudes beyond its range saturate, tiny ones become 0.
std::uint16_t to_half(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16U) & 0x8000U;
  const std::uint32_t rounded = (bits & 0x7FFFFFFFU) + 0x1000U;
  if (rounded < 0x38800000U) return static_cast<std::uint16_t>(sign);             // below 2⁻¹⁴
  if (rounded >= 0x47800000U) return static_cast<std::uint16_t>(sign | 0x7BFFU);  // 65,504 and beyond
  return static_cast<std::uint16_t>(sign | ((rounded - 0x38000000U) >> 13U));
}

float from_half(std::uint16_t half) {
  const std::uint32_t sign = (half & 0x8000U) << 16U, rest = half & 0x7FFFU;
  if (rest == 0) return std::bit_cast<float>(sign);
  return std::bit_cast<float>(sign | ((rest << 13U) + 0x38000000U));
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 8 && i + k < bytes.size(); ++k)
      word |= std::uint64_t{static_cast<unsigned char>(bytes[i + k])} << (8 * k);
    hash = (hash ^ word) * 0x100000001B3ULL;
    hash ^= hash >> 32U;
  }
  return hash;
}

WeightsWriter::WeightsWriter(std::uint32_t version) : bytes_(magic) { number(version); }

void WeightsWriter::strings(const std::vector<std::string>& list) {
  number(static_cast<std::uint32_t>(list.size()));
  for (const std::string& s : list) {
    number(static_cast<std::uint16_t>(s.size()));
    bytes_ += s;
  }
}

void WeightsWriter::gap(std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) number(static_cast<std::uint8_t>(value | 0x80U));
  number(static_cast<std::uint8_t>(value));
}

void WeightsWriter::table(const WeightTable& table, double threshold) {
  using Kept = std::vector<std::pair<std::size_t, std::uint16_t>>;  // columns and weights
  std::vector<std::pair<std::uint64_t, Kept>> rows;
  for (std::uint32_t r = 0; r < table.rows(); ++r) {
    Kept kept;
    for (std::size_t c = 0; c < table.columns(); ++c) {
      const std::uint16_t half = to_half(table.weight(r, c));
      if (const float kept_as = from_half(half); kept_as != 0 && std::abs(kept_as) >= threshold)
        kept.emplace_back(c, half);
    }
    if (!kept.empty()) rows.emplace_back(table.key(r), std::move(kept));
  }
  std::sort(rows.begin(), rows.end());
  number(static_cast<std::uint32_t>(table.columns()));
  number(static_cast<std::uint32_t>(rows.size()));
  std::uint64_t last = 0;
  for (const auto& [feature, kept] : rows) {
    gap(feature - std::exchange(last, feature));
    if (table.columns() > 1) gap(kept.size());
    std::size_t next = 0;
    for (const auto& [column, half] : kept) {
      if (table.columns() > 1) gap(column - std::exchange(next, column + 1));
      number(half);
    }
  }
}

void WeightsWriter::floats(std::span<const float> values) {
  number(static_cast<std::uint32_t>(values.size()));
  for (const float value : values) number(std::bit_cast<std::uint32_t>(value));
}

std::string WeightsWriter::finish() {
  number(checksum(bytes_));
  return std::move(bytes_);
}

WeightsReader::WeightsReader(std::string_view bytes, std::string_view source)
    : bytes_(bytes), source_(source) {
  if (bytes.substr(0, magic.size()) != magic) fail("is no weights file of waymark");
  if (bytes.size() < magic.size() + 12) fail("the weights file is cut short");
  at_ = bytes.size() - 8;
  const auto sum = number<std::uint64_t>();
  bytes_ = bytes.substr(0, bytes.size() - 8);
  at_ = magic.size();
  version_ = number<std::uint32_t>();
  if (version_ < 9 || version_ > 12)  // 1 to 8 had other features or wider tables
    fail("weights file of version " + std::to_string(version_) + ", this waymark reads versions 9 to 12");
  if (sum != checksum(bytes_)) fail("the weights file is damaged: its checksum does not fit");
}

void WeightsReader::fail(const std::string& message) const { throw ltl::FormatError(source_, 0, 0, message); }

std::string_view WeightsReader::raw(std::size_t n) {
  if (n > bytes_.size() - at_) fail("the weights file is cut short");
  at_ += n;
  return bytes_.substr(at_ - n, n);
}

std::size_t WeightsReader::count(std::size_t bytes_each) {
  const auto n = number<std::uint32_t>();
  if (n > (bytes_.size() - at_) / bytes_each) fail("the weights file promises more than it holds");
  return n;
}

std::vector<std::string> WeightsReader::strings() {
  std::vector<std::string> list(count(2));
  for (std::string& s : list) s = raw(number<std::uint16_t>());
  return list;
}

ltl::Vocabulary WeightsReader::vocabulary() {
  const std::vector<std::string> names = strings();
  for (const std::string& name : names)
    if (name.empty()) fail("a proposition without a name");
  if (names.size() > 20'000) fail("more than 20,000 propositions");
  ltl::Vocabulary vocabulary(names);
  if (vocabulary.size() != names.size()) fail("a proposition stands twice");
  return vocabulary;
}

WordTable WeightsReader::words() {
  WordTable words;
  for (const std::string& word : strings()) words.add(word);
  return words;
}

std::uint64_t WeightsReader::gap() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    const std::uint64_t byte = number<std::uint8_t>();
    if (shift == 63 && byte > 1) break;
    value |= (byte & 0x7FU) << shift;
    if (byte < 0x80U) return value;
  }
  fail("a number takes more than 64 bits");
}

void WeightsReader::table(WeightTable& table) {
  if (number<std::uint32_t>() != table.columns()) fail("a table's width does not fit the vocabulary");
  const std::size_t rows = count(3);
  if (rows > most_weights / table.columns()) fail("a table is too large");
  table.reserve(rows);
  std::vector<WeightTable::Weight> weights;
  std::uint64_t feature = 0;
  for (std::size_t r = 0; r < rows; ++r) {
    const std::uint64_t further = gap();
    if (further > std::numeric_limits<std::uint64_t>::max() - feature)
      fail("a feature takes more than 64 bits");
    feature += further;
    weights.clear();
    std::uint64_t next = 0;  // column
    for (std::uint64_t left = table.columns() > 1 ? gap() : 1; left > 0; --left, ++next) {
      const std::uint64_t skipped = table.columns() > 1 ? gap() : 0;
      if (skipped >= table.columns() - next) fail("a weight lies outside its table");
      next += skipped;
      weights.push_back({static_cast<std::uint16_t>(next), from_half(number<std::uint16_t>())});
    }
    if (!table.add_row(feature, weights)) fail("a feature stands twice");
  }
}

void WeightsReader::floats(std::span<float> values) {
  if (count(4) != values.size()) fail("the number of weights does not fit the sizes of the layers");
  for (float& value : values) {
    value = std::bit_cast<float>(number<std::uint32_t>());
    if (!std::isfinite(value)) fail("a weight is no number");
  }
}

void WeightsReader::end() const {
  if (at_ != bytes_.size()) fail("the weights file goes on after its end");
}

void write_weights(const std::string& bytes, const std::string& file) {
  const std::filesystem::path temporary = file + ".tmp";
  std::ofstream out(temporary, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, file, error);
  if (out && !error) return;
  std::filesystem::remove(temporary, error);
  throw ltl::FormatError(file, 0, 0, "cannot be written");
}

}  // namespace waymark::parser
