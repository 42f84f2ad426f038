// Bytes of model files, little endian: lists that begin at multiples of eight bytes, and a checksum at the end.
// Layout: docs/formats/corpus-and-models.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libparser/model/mapped_file.hpp"
#include "libparser/model/weight_table.hpp"
#include "libparser/model/word_table.hpp"
#include "libparser/programs/postfix_grammar.hpp"

namespace waymark::parser {

// What a model file says of itself first.
struct ModelHeader {
  static constexpr std::uint32_t version = 16;  // others are refused
  std::uint16_t kind = 0;                       // `file_kind` of the word model
  Dialect dialect = Dialect::Plain;             // of the programs
};

class WeightsWriter {  // of one model file
 public:
  explicit WeightsWriter(const ModelHeader& header);  // begins the file

  void number(std::uint64_t value);  // eight bytes
  // The number of elements, the elements, and zeros up to a multiple of eight bytes.
  template <class T>
  void list(const T& elements) {
    using Element = std::remove_cvref_t<decltype(elements[0])>;
    static_assert(std::is_arithmetic_v<Element>);
    number(elements.size());
    bytes_.append(reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element));
    bytes_.resize((bytes_.size() + 7) / 8 * 8);
  }
  void strings(const std::vector<std::string>& list);
  void table(const WeightTable& table, double threshold);  // without weights below the threshold
  std::string finish();                                    // with the checksum

 private:
  std::string bytes_;
};

// Every member throws ltl::FormatError when the bytes are not what they should be.
class WeightsReader {
 public:
  // Checks what stands around: that it is a model file, of this version, whole and unaltered.
  WeightsReader(std::shared_ptr<const MappedFile> file, std::string_view source);

  const ModelHeader& header() const { return header_; }  // of the file
  std::uint64_t number();                                // eight bytes
  template <class T>
  std::span<const T> list() {  // where it lies
    const std::uint64_t n = number();
    if (n > left() / sizeof(T)) fail("the model file promises more than it holds");
    const void* const first = bytes_.data() + at_;
    at_ += (n * sizeof(T) + 7) / 8 * 8;
    return {static_cast<const T*>(first), n};
  }
  std::vector<std::string> strings();                        // a list of texts
  ltl::Vocabulary vocabulary();                              // a list of names
  WordTable words();                                         // a list of words
  WeightTable table(std::size_t columns);                    // of rows that stay where they lie
  void floats(std::span<float> values);                      // as many as there are, all of them finite
  std::size_t left() const { return bytes_.size() - at_; }   // bytes to read
  void end() const;                                          // nothing may follow
  [[noreturn]] void fail(const std::string& message) const;  // throws ltl::FormatError

 private:
  void check_rows(const StoredRows& stored, std::size_t columns) const;

  std::shared_ptr<const MappedFile> file_;
  std::string_view bytes_, source_;
  std::size_t at_ = 0;
  ModelHeader header_;
};

}  // namespace waymark::parser
