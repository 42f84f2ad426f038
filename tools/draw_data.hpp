// Pictures of data: learning curves from an answer of `waymark compare --json`, tables from tables.
#pragma once
#include <string>
#include <string_view>

namespace waymark::tools {

// The first answer of the text. Throws ltl::FormatError: it has no curves.
std::string curves_picture(std::string_view text, std::string_view source);

// Of CSV or TSV with a heading [RFC 4180], JSON lines, or a list of objects, also under "methods" or "rows". At most
// 1,000 rows and 40 columns. Throws ltl::FormatError.
std::string table_picture(std::string_view text, std::string_view source);

}  // namespace waymark::tools
