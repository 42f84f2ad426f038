// Text → formula. A stack machine: the infix form by operator precedence, the prefix and postfix forms directly.
//
// Infix, loosest first:  <->   ->   ^   |   &   U R W M S T (and U<=k)   ! X N F G Y Z O H (and X[!] X[w] WX F<=k G<=k)
// `->` and the binary temporal operators associate to the right. Grammar in full: docs/formats/formulas.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "libltl/formula.hpp"
#include "libltl/text/symbol.hpp"

namespace waymark::ltl {

enum class Unknown : std::uint8_t {  // what happens to unknown names
  Add,                               // a name that the arena's vocabulary lacks is added to it
  Reject,                            // … is a SyntaxError with the nearest known name as a hint
};

struct ParseOptions {                   // how a text is read
  Dialect dialect = Dialect::Waymark;   // what X means
  Notation notation = Notation::Infix;  // infix, prefix or postfix
  Unknown unknown = Unknown::Add;       // names that are new
};

inline constexpr std::size_t most_levels = 10'000;  // of nesting in a formula that was read

// Throws SyntaxError (diagnostic.hpp). Time and memory O(|text| log |text|), bounds spelled out; no recursion.
Formula parse(std::string_view text, Arena& arena, const ParseOptions& options = {});

}  // namespace waymark::ltl
