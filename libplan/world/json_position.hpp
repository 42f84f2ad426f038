// The position of a value in a JSON text, so that a wrong value is reported with its line and column.
//
// The JSON library reports positions of syntax errors only. For a document that parses and has a wrong value, this code
// scans the text again. The scan runs in the case of an error only.
#pragma once
#include <cstddef>
#include <string_view>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {

// The first byte of the value that `path` leads to, like "nodes[3].x"; "" is the document itself. `json` must be
// valid JSON. Where the path leaves the document (a missing key), the value it left. Of a key given twice the last
// counts, as in the reader. O(|json|).
std::size_t offset_of(std::string_view json, std::string_view path);

// "nodes[3].x: expected a whole number" at the line and column of that value. The text begins in `first_line` of its
// file.
ltl::FormatError format_error(std::string_view source, std::string_view json, std::string_view path,
                              std::string_view message, std::size_t first_line = 1);
// The same for a byte of the text, for syntax errors.
ltl::FormatError format_error_at(std::string_view source, std::string_view text, std::size_t offset,
                                 std::string_view message, std::size_t first_line = 1);

}  // namespace waymark::plan
