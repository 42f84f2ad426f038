// Formula → text. print(parse(s)) is a normal form; parse(print(φ)) = φ, as pointers, for all styles but Latex.
//
// F G W M -> ^ and, except for Lbt and Postfix, F<=k G<=k (k ≥ 2) are recognised in the stored formula. Operands of & |
// <-> keep the order in which they were made. A binary operator inside another one has parentheses; unary operators
// have none. Cost: the length of the text, which is the size of the syntax tree and not of the DAG.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// How operators are spelled, and where they stand.
enum class Style : std::uint8_t { Ascii, Unicode, Latex, Lbt, Postfix };

std::string print(Formula f, Style style = Style::Ascii);

// The name of a proposition as it stands in a formula: quoted where it must be, escaped for LaTeX.
std::string print_name(std::string_view name, Style style = Style::Ascii);

}  // namespace waymark::ltl
