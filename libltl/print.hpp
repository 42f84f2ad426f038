// Formula → text. print(parse(s)) is a normal form; parse(print(φ)) = φ for Ascii, Unicode, Lbt and Postfix.
#pragma once
#include <cstdint>
#include <string>

#include "libltl/formula.hpp"

namespace waymark::ltl {

enum class Style : std::uint8_t { Ascii, Unicode, Latex, Lbt, Postfix };

std::string print(Formula f, Style style = Style::Ascii);

}  // namespace waymark::ltl
