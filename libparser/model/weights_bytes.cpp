#include "libparser/model/weights_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"

namespace waymark::parser {
namespace {

constexpr std::string_view magic = "waymark\n";
constexpr std::size_t header_bytes = 16, checksum_bytes = 8;

void append_leb128(std::string& out, std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) out += static_cast<char>(value | 0x80U);
  out += static_cast<char>(value);
}

template <class T>
T read_at(std::string_view bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

struct Weight {
  std::uint64_t feature;
  std::uint16_t column, half;
};

std::vector<Weight> kept(const WeightTable& table, double threshold) {
  std::vector<Weight> out;
  table.each([&](std::uint64_t feature, std::size_t column, float weight) {
    const std::uint16_t half = half_of(weight);
    if (const float rounded = float_of(half); rounded != 0 && std::abs(rounded) >= threshold)
      out.push_back({feature, static_cast<std::uint16_t>(column), half});
  });
  std::sort(out.begin(), out.end(), [](const Weight& a, const Weight& b) {
    return a.feature != b.feature ? a.feature < b.feature : a.column < b.column;
  });
  return out;
}

// The bytes of a table's rows, read with the care that bytes of unknown origin need.
struct RowBytes {
  std::string_view bytes;
  std::size_t columns, at = 0;
  const char* wrong = nullptr;  // what was wrong first

  std::uint64_t failed(const char* what) {
    if (wrong == nullptr) wrong = what;
    return 0;
  }
  std::uint64_t leb128() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      if (at == bytes.size()) return failed("a table is cut short");
      const auto byte = static_cast<unsigned char>(bytes[at++]);
      if (shift == 63 && byte > 1) break;
      value |= std::uint64_t{byte & 0x7FU} << shift;
      if (byte < 0x80U) return value;
    }
    return failed("a number in a table takes more than 64 bits");
  }
  void pass_weights() {
    std::uint64_t column = 0;
    for (std::uint64_t left = columns > 1 ? leb128() : 1; left > 0 && wrong == nullptr; --left, ++column) {
      const std::uint64_t skipped = columns > 1 ? leb128() : 0;
      if (skipped >= columns - column) failed("a weight lies outside its table");
      column += skipped;
      if (bytes.size() - at < sizeof(std::uint16_t)) {
        failed("a table is cut short");
      } else if ((read_at<std::uint16_t>(bytes, at) & 0x7C00U) == 0x7C00U) {
        failed("a weight is no finite number");
      }
      at = std::min(at + sizeof(std::uint16_t), bytes.size());
    }
  }
};

}  // namespace

WeightsWriter::WeightsWriter(const ModelHeader& header) : bytes_(magic) {
  const auto plain = static_cast<std::uint32_t>(header.dialect) << 16U;
  number(ModelHeader::version | std::uint64_t{plain | header.kind} << 32U);
}

void WeightsWriter::number(std::uint64_t value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }

void WeightsWriter::strings(const std::vector<std::string>& list_of_strings) {
  std::vector<std::uint32_t> ends;
  std::string text;
  for (const std::string& s : list_of_strings) {
    text += s;
    ends.push_back(static_cast<std::uint32_t>(text.size()));
  }
  list(ends);
  list(text);
}

void WeightsWriter::table(const WeightTable& table, double threshold) {
  const std::vector<Weight> weights = kept(table, threshold);
  std::string rows;
  std::vector<std::uint64_t> last;
  std::vector<std::uint32_t> ends;
  std::uint64_t number_of_rows = 0, feature = 0;
  for (auto row = weights.begin(); row != weights.end();) {
    const auto next = std::find_if(row, weights.end(), [&](const Weight& w) { return w.feature != row->feature; });
    append_leb128(rows, row->feature - std::exchange(feature, row->feature));
    if (table.columns() > 1) append_leb128(rows, static_cast<std::uint64_t>(next - row));
    for (std::size_t column = 0; row != next; ++row) {
      if (table.columns() > 1) append_leb128(rows, row->column - std::exchange(column, row->column + 1U));
      rows.append(reinterpret_cast<const char*>(&row->half), sizeof row->half);
    }
    if (++number_of_rows % StoredRows::block == 0 || next == weights.end()) {
      last.push_back(feature);
      ends.push_back(static_cast<std::uint32_t>(rows.size()));
    }
  }
  number(table.columns());
  number(number_of_rows);
  list(last);
  list(ends);
  list(rows);
}

std::string WeightsWriter::finish() {
  number(ltl::xxh64(bytes_));
  return std::move(bytes_);
}

WeightsReader::WeightsReader(std::shared_ptr<const MappedFile> file, std::string_view source)
    : file_(std::move(file)), bytes_(file_->bytes()), source_(source), at_(header_bytes) {
  if (bytes_.substr(0, magic.size()) != magic) fail("is no model file of waymark");
  if (bytes_.size() < header_bytes + checksum_bytes) fail("the model file is cut short");
  const auto version = read_at<std::uint32_t>(bytes_, magic.size());
  if (version != ModelHeader::version)
    fail("is a model file of version " + std::to_string(version) + ", and this waymark reads version " +
         std::to_string(ModelHeader::version) + ": train the model again with waymark train");
  const auto sum = read_at<std::uint64_t>(bytes_, bytes_.size() - checksum_bytes);
  bytes_.remove_suffix(checksum_bytes);
  if (bytes_.size() % 8 != 0 || sum != ltl::xxh64(bytes_)) fail("the model file is damaged: its checksum does not fit");
  const auto kind = read_at<std::uint16_t>(bytes_, 12), dialect = read_at<std::uint16_t>(bytes_, 14);
  if (dialect > 1) fail("is a model file of an unknown kind");
  header_ = {kind, static_cast<Dialect>(dialect)};
}

void WeightsReader::fail(const std::string& message) const { throw ltl::FormatError(source_, 0, 0, message); }

std::uint64_t WeightsReader::number() {
  if (left() < sizeof(std::uint64_t)) fail("the model file is cut short");
  at_ += sizeof(std::uint64_t);
  return read_at<std::uint64_t>(bytes_, at_ - sizeof(std::uint64_t));
}

std::vector<std::string> WeightsReader::strings() {
  const auto ends = list<std::uint32_t>();
  const auto text = list<char>();
  std::vector<std::string> out;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ends) {
    if (end < begin || end > text.size()) fail("a string lies outside its text");
    out.emplace_back(text.data() + begin, end - begin);
    begin = end;
  }
  return out;
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
  const std::vector<std::string> list_of_words = strings();
  WordTable words;
  for (const std::string& word : list_of_words) words.add(word);
  if (words.words() != list_of_words) fail("the words are not a table of words");
  return words;
}

WeightTable WeightsReader::table(std::size_t columns) {
  if (number() != columns) fail("a table's width does not fit the vocabulary");
  StoredRows stored;
  stored.file = file_;
  stored.rows = number();
  stored.last = list<std::uint64_t>();
  stored.end = list<std::uint32_t>();
  const auto bytes = list<char>();
  stored.bytes = {bytes.data(), bytes.size()};
  check_rows(stored, columns);
  return WeightTable(columns, std::move(stored));
}

void WeightsReader::check_rows(const StoredRows& stored, std::size_t columns) const {
  const std::size_t blocks = stored.rows / StoredRows::block + (stored.rows % StoredRows::block > 0 ? 1 : 0);
  if (stored.bytes.size() > UINT32_MAX || stored.last.size() != blocks || stored.end.size() != blocks)
    fail("a table's index does not fit its rows");
  RowBytes rows{stored.bytes, columns};
  std::uint64_t feature = 0;
  for (std::size_t r = 0; r < stored.rows; ++r) {
    const std::uint64_t further = rows.leb128();
    if (further == 0 && r > 0) fail("a feature stands twice");
    if (further > std::numeric_limits<std::uint64_t>::max() - feature) fail("a feature takes more than 64 bits");
    feature += further;
    rows.pass_weights();
    if (rows.wrong != nullptr) fail(rows.wrong);
    if ((r + 1) % StoredRows::block != 0 && r + 1 != stored.rows) continue;
    const std::size_t b = r / StoredRows::block;
    if (stored.last[b] != feature || stored.end[b] != rows.at) fail("a table's index does not fit its rows");
  }
  if (rows.at != stored.bytes.size()) fail("a table goes on after its end");
}

void WeightsReader::floats(std::span<float> values) {
  const auto stored = list<float>();
  if (stored.size() != values.size()) fail("the number of weights does not fit the sizes of the layers");
  if (!std::all_of(stored.begin(), stored.end(), [](float value) { return std::isfinite(value); }))
    fail("a weight is no finite number");
  std::copy(stored.begin(), stored.end(), values.begin());
}

void WeightsReader::end() const {
  if (at_ != bytes_.size()) fail("the model file goes on after its end");
}

}  // namespace waymark::parser
