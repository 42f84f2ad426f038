// Text → formula. Precedence climbing for infix, a stack for the prefix and postfix forms.
//
// Infix, loosest first:  <->   ->   ^   |   &   U R W M   ! X N F G (and X[!] X[w] WX F<=k G<=k)
// `->` and the binary temporal operators associate to the right. Grammar in full: docs/formats.md.
#pragma once
#include <cstdint>
#include <string_view>

#include "libltl/formula.hpp"

namespace waymark::ltl {

enum class Dialect : std::uint8_t {
  Waymark,  // X is the strong next, N (WX, X[w]) the weak one
  Spot,     // X is the weak next over finite words (TLSF, Syft, Lydia, Spot); X[!] the strong one
};
enum class Notation : std::uint8_t { Infix, Lbt, Postfix };
enum class Unknown : std::uint8_t {
  Add,     // a name that the arena's vocabulary lacks is added to it
  Reject,  // … is a SyntaxError with the nearest known name as a hint
};

struct ParseOptions {
  Dialect dialect = Dialect::Waymark;
  Notation notation = Notation::Infix;
  Unknown unknown = Unknown::Add;
};

// Throws SyntaxError (diagnostic.hpp). O(|text|), constant stack per nesting level, nesting limited to 10,000.
Formula parse(std::string_view text, Arena& arena, const ParseOptions& options = {});

}  // namespace waymark::ltl
