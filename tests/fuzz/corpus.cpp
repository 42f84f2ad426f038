// Corpora in JSON Lines: refused with a FormatError, or paragraphs whose sentences all have a trajectory.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/sail_corpus.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    for (const parser::Paragraph& paragraph : parser::parse_sail_corpus(text))
      for (const parser::Sentence& sentence : paragraph.sentences)
        if (sentence.absolute.empty() || sentence.relative.empty()) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}
