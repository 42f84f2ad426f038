// Formulas in every notation and dialect: a text is refused with a SyntaxError inside it, or read, and then printing
// and reading again gives the same formula.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace {

using namespace waymark::ltl;

void must(bool condition) {
  if (!condition) std::abort();
}

void read(std::string_view text, const ParseOptions& options) {
  Arena arena;
  try {
    const Formula f = parse(text, arena, options);
    if (tree_size(f) > 2'000) return;  // printing spells shared parts out
    for (Style style : {Style::Ascii, Style::Unicode}) must(parse(print(f, style), arena) == f);
    must(parse(print(f, Style::Lbt), arena, {.notation = Notation::Lbt}) == f);
    must(parse(print(f, Style::Postfix), arena, {.notation = Notation::Postfix}) == f);
  } catch (const SyntaxError& error) {
    must(error.where().begin <= error.where().end && error.where().end <= text.size() + 1);
    must(error.line() >= 1 && error.column() >= 1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  const Notation notations[] = {Notation::Infix, Notation::Lbt, Notation::Postfix};
  const Dialect dialects[] = {Dialect::Waymark, Dialect::Spot, Dialect::Nusmv, Dialect::Psl};
  read(text, {.dialect = dialects[data[0] / 3U % 4U], .notation = notations[data[0] % 3U]});
  return 0;
}
