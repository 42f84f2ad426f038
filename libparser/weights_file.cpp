#include "libparser/weights_file.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

constexpr std::string_view magic = "waymark\n";
constexpr std::uint32_t version = 1;
constexpr std::size_t most_weights = std::size_t{1} << 25U;  // of a table, while reading

// FNV-1a over little-endian 64-bit words, the last one padded with zeros.
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

class Writer {
 public:
  template <class Unsigned>
  void number(Unsigned value) {
    for (std::size_t k = 0; k < sizeof(Unsigned); ++k)
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * k) & 0xFFU);
  }
  void strings(const std::vector<std::string>& list) {
    number(static_cast<std::uint32_t>(list.size()));
    for (const std::string& s : list) {
      number(static_cast<std::uint16_t>(s.size()));
      bytes_ += s;
    }
  }
  void table(const WeightTable& table, double threshold) {
    std::vector<std::pair<std::uint32_t, std::vector<std::pair<std::uint16_t, std::uint16_t>>>> rows;
    for (std::uint32_t r = 0; r < table.rows(); ++r) {
      std::vector<std::pair<std::uint16_t, std::uint16_t>> kept;
      for (std::size_t c = 0; c < table.columns(); ++c) {
        const std::uint16_t half = to_half(table.weight(r, c));
        if (std::abs(from_half(half)) >= threshold) kept.emplace_back(static_cast<std::uint16_t>(c), half);
      }
      if (!kept.empty()) rows.emplace_back(r, std::move(kept));
    }
    number(static_cast<std::uint32_t>(table.columns()));
    number(static_cast<std::uint32_t>(rows.size()));
    for (const auto& [r, kept] : rows) {
      number(table.key(r));
      number(static_cast<std::uint16_t>(kept.size()));
      for (const auto& [column, half] : kept) {
        number(column);
        number(half);
      }
    }
  }
  void raw(std::string_view s) { bytes_ += s; }
  std::string finish() {
    number(checksum(bytes_));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string_view bytes, std::string_view source) : bytes_(bytes), source_(source) {}

  [[noreturn]] void fail(const std::string& message) const { throw ltl::FormatError(source_, 0, 0, message); }

  std::string_view raw(std::size_t n) {
    if (n > bytes_.size() - at_) fail("the weights file is cut short");
    at_ += n;
    return bytes_.substr(at_ - n, n);
  }
  template <class Unsigned>
  Unsigned number() {
    const std::string_view s = raw(sizeof(Unsigned));
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < sizeof(Unsigned); ++k)
      value |= std::uint64_t{static_cast<unsigned char>(s[k])} << (8 * k);
    return static_cast<Unsigned>(value);
  }
  std::size_t count(std::size_t bytes_each) {
    const auto n = number<std::uint32_t>();
    if (n > (bytes_.size() - at_) / bytes_each) fail("the weights file promises more than it holds");
    return n;
  }
  std::vector<std::string> strings() {
    std::vector<std::string> list(count(2));
    for (std::string& s : list) s = raw(number<std::uint16_t>());
    return list;
  }
  void table(WeightTable& table) {
    if (number<std::uint32_t>() != table.columns()) fail("a table's width does not fit the vocabulary");
    const std::size_t rows = count(10);
    if (rows > most_weights / table.columns()) fail("a table is too large");
    table.reserve(rows);
    std::vector<WeightTable::Weight> weights;
    for (std::size_t r = 0; r < rows; ++r) {
      const auto feature = number<std::uint64_t>();
      weights.clear();
      for (std::size_t left = number<std::uint16_t>(); left > 0; --left) {
        const auto column = number<std::uint16_t>();
        if (column >= table.columns()) fail("a weight lies outside its table");
        weights.push_back({column, from_half(number<std::uint16_t>())});
      }
      if (!table.add_row(feature, weights)) fail("a feature stands twice");
    }
  }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::string_view bytes_, source_;
  std::size_t at_ = 0;
};

}  // namespace

std::string serialize(const LinearModel& model, double threshold) {
  Writer out;
  out.raw(magic);
  out.number(version);
  out.strings(model.vocabulary().names());
  out.strings(model.words.words());
  out.table(model.reader, threshold);
  out.table(model.chooser, threshold);
  return out.finish();
}

LinearModel parse_linear_model(std::string_view bytes, std::string_view source) {
  Reader whole(bytes, source);
  if (bytes.substr(0, magic.size()) != magic) whole.fail("is no weights file of waymark");
  if (bytes.size() < magic.size() + 12) whole.fail("the weights file is cut short");
  Reader tail(bytes.substr(bytes.size() - 8), source);
  const std::string_view body = bytes.substr(0, bytes.size() - 8);
  Reader in(body, source);
  in.raw(magic.size());
  if (const auto v = in.number<std::uint32_t>(); v != version)
    in.fail("weights file of version " + std::to_string(v) + ", this waymark reads version " +
            std::to_string(version));
  if (tail.number<std::uint64_t>() != checksum(body))
    in.fail("the weights file is damaged: its checksum does not fit");
  const std::vector<std::string> names = in.strings();
  for (const std::string& name : names)
    if (name.empty()) in.fail("a proposition without a name");
  const ltl::Vocabulary vocabulary(names);
  if (vocabulary.size() != names.size()) in.fail("a proposition stands twice");
  if (vocabulary.size() > 20'000) in.fail("more than 20,000 propositions");
  LinearModel model(vocabulary);
  for (const std::string& word : in.strings()) model.words.add(word);
  in.table(model.reader);
  in.table(model.chooser);
  if (!in.at_end()) in.fail("the weights file goes on after its end");
  return model;
}

std::string serialize_within(const LinearModel& model, std::size_t bytes) {
  double threshold = least_weight;
  std::string out = serialize(model, threshold);
  while (out.size() > bytes && threshold < 65'504) out = serialize(model, threshold *= 1.25);
  return out;
}

void save(const LinearModel& model, const std::filesystem::path& file) {
  const std::filesystem::path temporary = file.string() + ".tmp";
  std::ofstream out(temporary, std::ios::binary);
  const std::string bytes = serialize_within(model, most_bytes);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, file, error);
  if (out && !error) return;
  std::filesystem::remove(temporary, error);
  throw ltl::FormatError(file.string(), 0, 0, "cannot be written");
}

LinearModel load_linear_model(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in || !bytes) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  return parse_linear_model(bytes.view(), file.string());
}

}  // namespace waymark::parser
