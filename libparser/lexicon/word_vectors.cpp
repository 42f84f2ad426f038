#include "libparser/lexicon/word_vectors.hpp"

#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

constexpr std::string_view magic = "waymark words 1\n";

// Takes entries from the front of the bytes, without a copy.
class Bytes {
 public:
  Bytes(std::string_view bytes, std::string_view source) : rest_(bytes), source_(source) {}

  std::string_view take(std::size_t n) {
    if (rest_.size() < n) throw ltl::FormatError(std::string(source_), 0, 0, "the word vectors are cut short");
    const std::string_view taken = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return taken;
  }
  template <class Entry>
  std::span<const Entry> array(std::size_t n) {
    return {reinterpret_cast<const Entry*>(take(n * sizeof(Entry)).data()), n};
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_, source_;
};

}  // namespace

WordVectors::WordVectors(std::string_view bytes, std::string_view source) : bytes_(bytes) {
  Bytes in(bytes, source);
  if (bytes.substr(0, magic.size()) != magic)
    throw ltl::FormatError(std::string(source), 0, 0, "these are no word vectors of version 1");
  in.take(magic.size());
  const auto head = in.array<std::uint32_t>(2);
  if (head[1] != dimensions) throw ltl::FormatError(std::string(source), 0, 0, "word vectors of another length");
  ends_ = in.array<std::uint32_t>(head[0]);
  for (std::size_t i = 0; i < ends_.size(); ++i)
    if (ends_[i] < (i > 0 ? ends_[i - 1] : 0))
      throw ltl::FormatError(std::string(source), 0, 0, "the words of the vectors are damaged");
  words_ = in.take(ends_.empty() ? 0 : (std::size_t{ends_.back()} + 3) / 4 * 4);
  scales_ = in.array<float>(head[0]);
  for (const float scale : scales_)
    if (!std::isfinite(scale)) throw ltl::FormatError(std::string(source), 0, 0, "a scale that is no finite number");
  entries_ = in.array<std::int8_t>(std::size_t{head[0]} * dimensions);
  if (!in.at_end()) throw ltl::FormatError(std::string(source), 0, 0, "there is more after the word vectors");
}

std::shared_ptr<const WordVectors> WordVectors::shared(std::shared_ptr<const void> owner, std::string_view bytes,
                                                       std::string_view source) {
  struct Owned {
    std::shared_ptr<const void> owner;
    WordVectors vectors;
  };
  const auto owned = std::make_shared<const Owned>(Owned{std::move(owner), WordVectors(bytes, source)});
  return {owned, &owned->vectors};
}

std::string_view WordVectors::word(std::size_t row) const {
  const std::size_t begin = row > 0 ? ends_[row - 1] : 0;
  return words_.substr(begin, ends_[row] - begin);
}

std::optional<std::size_t> WordVectors::find(std::string_view wanted) const {
  std::size_t low = 0, high = size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (word(middle) < wanted)
      low = middle + 1;
    else
      high = middle;
  }
  if (low == size() || word(low) != wanted) return std::nullopt;
  return low;
}

double WordVectors::similarity(std::size_t a, std::size_t b) const {
  const auto x = entries(a), y = entries(b);
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < dimensions; ++i) {
    xy += x[i] * y[i];
    xx += x[i] * x[i];
    yy += y[i] * y[i];
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

}  // namespace waymark::parser
