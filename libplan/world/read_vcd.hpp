// Value change dumps (VCD, IEEE 1364): the waveforms of simulators, as a table of letters.
//
// A row is one time at which something changes; its columns are the time and the variables, by their names, with their
// scopes in front where a name stands for several. A scalar is 1, 0, or ? where it is x or z; a vector is its number,
// or ?; a real is itself.
#pragma once
#include <string>
#include <string_view>

namespace waymark::plan {

bool is_vcd(std::string_view text);  // by its first keyword
// A text as letter_table.hpp reads it, tabs between cells. Throws ltl::FormatError.
std::string table_of_vcd(std::string_view text, std::string_view source);

}  // namespace waymark::plan
