#include "libplan/product/ranked_set.hpp"

#include <algorithm>

namespace waymark::plan {

void RankedSet::rank() {
  std::uint32_t before = 0;
  for (Word& word : words_) {
    word.before = before;
    before += static_cast<std::uint32_t>(std::popcount(word.bits));
  }
}

std::uint64_t RankedSet::select(std::uint32_t rank) const {
  const auto after = std::upper_bound(words_.begin(), words_.end(), rank,
                                      [](std::uint32_t r, const Word& word) { return r < word.before; });
  const Word& word = *(after - 1);
  std::uint64_t bits = word.bits;
  for (std::uint32_t skip = rank - word.before; skip > 0; --skip) bits &= bits - 1;
  return 64 * static_cast<std::uint64_t>(after - 1 - words_.begin()) +
         static_cast<std::uint64_t>(std::countr_zero(bits));
}

}  // namespace waymark::plan
