// Names that every writer can write: of propositions, states and actions.
#pragma once
#include <string_view>

namespace waymark::ltl {

// Is the text UTF-8 without control characters, line ends excepted? Others would steer terminals and break pictures: no
// reader takes them, and Vocabulary::add throws FormatError.
bool is_printable_name(std::string_view name);

}  // namespace waymark::ltl
