// Where in a JSON text a value stands, so that a value of the wrong shape is reported with its line and column.
//
// The JSON library tells positions of syntax errors only; a document that parsed but means nothing needs a second
// look. Scanning happens on the error path alone.
#pragma once
#include <cstddef>
#include <string_view>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {

// The first byte of the value that `path` leads to, like "nodes[3].x"; "" is the document itself. `json` must be
// valid JSON. Where the path leaves the document (a missing key), the value it left. Of a key given twice the last
// counts, as in the reader. O(|json|).
std::size_t offset_of(std::string_view json, std::string_view path);

// "nodes[3].x: expected a whole number" at the line and column of that value. The text begins in `first_line` of its file.
ltl::FormatError format_error(std::string_view source, std::string_view json, std::string_view path,
                              std::string_view message, std::size_t first_line = 1);
// The same for a byte of the text, for syntax errors.
ltl::FormatError format_error_at(std::string_view source, std::string_view text, std::size_t offset,
                                 std::string_view message, std::size_t first_line = 1);

}  // namespace waymark::plan
