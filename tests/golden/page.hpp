// A page of the manual whose commands are run. In a block ```console, a line that starts with `$ ` begins a command,
// lines that start with `> ` continue the command, and the other lines, up to the next command or the end of the block,
// are what the command prints.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace waymark::golden {

// The page as it would be written now: the same prose and commands, fresh answers. The commands run in that folder.
std::string rerun_page(const std::string& page, const std::filesystem::path& folder);

// The commands of a page, in order, with line breaks where they have several lines.
std::vector<std::string> commands_of(const std::string& page);

// Runs the commands of the page in a new, empty folder and compares what they print with the page; see `compare`.
void expect_page_is_true(const std::filesystem::path& page);

}  // namespace waymark::golden
