// The page of `waymark SUBCOMMAND --help`: options in groups, at most 100 columns and 45 lines, examples at the end.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/shell/command.hpp"

namespace waymark::tools {

struct HelpText {
  std::string usage = {}, summary = {};
  std::vector<OptionText> options = {};
  std::vector<std::pair<std::string, std::string>> commands = {};  // name, summary
  std::string examples = {};                                       // the last lines of the page
};

inline constexpr std::size_t help_columns = 100, help_lines = 45;

// Groups stand in the order of their first option. Those that the page has no room for are named in one line with
// their number of options; `all` shows them too.
std::string help_page(const HelpText& text, bool all);

// Lines of at most `columns` characters of UTF-8, broken at blanks; a longer word stands alone.
std::vector<std::string> lines_of(std::string_view text, std::size_t columns);

}  // namespace waymark::tools
