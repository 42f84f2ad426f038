#include "libplan/product/ranked_set.hpp"

#include <algorithm>

namespace waymark::plan {

void RankedSet::rank() {
  std::uint32_t before = 0;
  every_.clear();
  for (std::size_t w = 0; w < words_.size(); ++w) {
    words_[w].before = before;
    before += static_cast<std::uint32_t>(std::popcount(words_[w].bits));
    while (std::uint64_t{every_.size()} * stride < before) every_.push_back(w);
  }
}

std::uint64_t RankedSet::select(std::uint32_t rank) const {
  const std::size_t mark = rank / stride;
  const auto at = [&](std::size_t i) { return words_.begin() + static_cast<std::ptrdiff_t>(every_[i]); };
  const auto last = mark + 1 < every_.size() ? at(mark + 1) + 1 : words_.end();
  const auto after =
      std::upper_bound(at(mark), last, rank, [](std::uint32_t r, const Word& word) { return r < word.before; });
  const Word& word = *(after - 1);
  std::uint64_t bits = word.bits;
  for (std::uint32_t skip = rank - word.before; skip > 0; --skip) bits &= bits - 1;
  return 64 * static_cast<std::uint64_t>(after - 1 - words_.begin()) +
         static_cast<std::uint64_t>(std::countr_zero(bits));
}

}  // namespace waymark::plan
