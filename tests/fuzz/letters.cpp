// Words: refused with an error, or letters, as one text and as lines of every format.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_word.hpp"
#include "libplan/world/letter_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    ltl::Vocabulary names;
    const ltl::AnyWord word = ltl::read_word(text, names);
    if (std::visit([](const auto& w) { return w.size(); }, word) == 0) std::abort();
  } catch (const ltl::SyntaxError&) {
  }
  using plan::LetterFormat;
  for (const auto format : {LetterFormat::Auto, LetterFormat::Text, LetterFormat::Json, LetterFormat::Csv}) try {
      if (plan::read_traces(text, {.format = format}, "").words.empty()) std::abort();
    } catch (const ltl::SyntaxError&) {
    } catch (const ltl::FormatError&) {
    }
  return 0;
}
