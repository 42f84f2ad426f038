// The text of a released file: UTF-8 without a byte order mark.
#pragma once
#include <string>
#include <string_view>

namespace waymark::parser {

// XML that declares ISO-8859-1 is converted. Throws ltl::FormatError, naming the line, for bytes that are no UTF-8.
std::string released_text(std::string bytes, std::string_view file);

}  // namespace waymark::parser
