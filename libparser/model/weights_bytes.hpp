// Bytes of weights files, little endian: numbers, strings and tables, and a checksum at the end.
// Layout: docs/formats/corpus-and-models.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libparser/model/linear_model.hpp"

namespace waymark::parser {

class WeightsWriter {
 public:
  explicit WeightsWriter(std::uint32_t version);  // begins the file

  template <class Unsigned>
  void number(Unsigned value) {
    for (std::size_t k = 0; k < sizeof(Unsigned); ++k)
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * k) & 0xFFU);
  }
  void strings(const std::vector<std::string>& list);
  void gap(std::uint64_t value);  // small ones in few bytes: seven bits each, the lowest first (LEB128)
  // By ascending features, as gaps, with weights as 16-bit floats; without those below the threshold.
  void table(const WeightTable& table, double threshold);
  void floats(std::span<const float> values);  // as they are
  std::string finish();                        // with the checksum

 private:
  std::string bytes_;
};

// Every member throws ltl::FormatError when the bytes are not what they should be.
class WeightsReader {
 public:
  // Checks what stands around: that it is a weights file, whole and unaltered. The bytes must outlive it.
  WeightsReader(std::string_view bytes, std::string_view source);

  std::uint32_t version() const { return version_; }
  template <class Unsigned>
  Unsigned number() {
    const std::string_view s = raw(sizeof(Unsigned));
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < sizeof(Unsigned); ++k)
      value |= std::uint64_t{static_cast<unsigned char>(s[k])} << (8 * k);
    return static_cast<Unsigned>(value);
  }
  std::uint64_t gap();
  std::vector<std::string> strings();
  ltl::Vocabulary vocabulary();
  WordTable words();
  void table(WeightTable& table);
  void floats(std::span<float> values);  // as many as there are, all of them finite
  std::size_t left() const { return bytes_.size() - at_; }
  void end() const;  // nothing may follow
  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string_view raw(std::size_t n);
  std::size_t count(std::size_t bytes_each);

  std::string_view bytes_, source_;
  std::size_t at_ = 0;
  std::uint32_t version_ = 0;
};

// What stands at the end of a file: FNV-1a over little-endian 64-bit words, the last one padded with zeros, the high half
// folded in after each.
std::uint64_t checksum(std::string_view bytes);

// Bytes → file, under a temporary name that is renamed. Throws ltl::FormatError when the file cannot be written.
void write_weights(const std::string& bytes, const std::string& file);

}  // namespace waymark::parser
