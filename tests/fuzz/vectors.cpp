// Word vectors: refused with a FormatError, or words within the bytes and similarities between -1 and 1.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libparser/lexicon/word_vectors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 8'192) return 0;
  std::vector<std::uint32_t> aligned(size / 4 + 1);  // as mapped files are
  if (size > 0) std::memcpy(aligned.data(), data, size);
  const std::string_view bytes(reinterpret_cast<const char*>(aligned.data()), size);
  try {
    const parser::WordVectors vectors(bytes);
    for (std::size_t row = 0; row < vectors.size(); ++row) {
      const std::string_view word = vectors.word(row);
      if (word.data() < bytes.data() || word.data() + word.size() > bytes.data() + bytes.size()) std::abort();
      if (const auto found = vectors.find(word); found && vectors.word(*found) != word) std::abort();
      if (!(std::abs(vectors.similarity(row, 0)) < 1.001)) std::abort();
    }
  } catch (const ltl::FormatError&) {
  }
  return 0;
}
