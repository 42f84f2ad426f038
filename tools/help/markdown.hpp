// Markdown of the manual as text for a terminal: headings, paragraphs, lists, tables in columns, code as it stands.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "tools/shell/terminal.hpp"

namespace waymark::tools {

// No line but one of code is longer than `columns`, as long as words and cells are not; links are their text alone.
std::string readable(std::string_view markdown, std::size_t columns, const Terminal& terminal);

}  // namespace waymark::tools
