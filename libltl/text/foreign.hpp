// Texts of well-known formats, told by how they begin: for the errors of readers that expect something else.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace waymark::ltl {

struct Foreign {
  std::string_view name;   // "a VCD file"
  std::string_view reads;  // what reads it, as a sentence; "" when nothing does
};

// Looks at the first lines only. Nothing for texts of no format that is known here.
std::optional<Foreign> foreign_format(std::string_view text);

// "this is a VCD file; waymark check --trace reads it", or "". Nothing is said of the format that the reader reads.
std::string foreign_hint(std::string_view text, std::string_view own = "");
// Throws FormatError at the first line where there is a hint: "expected letters: this is …".
void refuse_foreign(std::string_view text, std::string_view source, std::string_view expected,
                    std::string_view own = "");

}  // namespace waymark::ltl
