// The directories of maps and models, and of the helper executables: relative to this executable.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace waymark::tools {

std::filesystem::path executable();  // of this process, symbolic links resolved

// `option` (--data DIR) if not empty, else $WAYMARK_DATA, else ../share/waymark from the executable.
// Throws ltl::FormatError when that is no directory, saying which of the three was used.
std::filesystem::path data_directory(const std::string& option);

// `name` beside the executable or in ../libexec/waymark; empty when it was not built or installed.
std::filesystem::path helper(std::string_view name);

// The same; throws UsageError that says what `name` does and how it is built when it is not there.
std::filesystem::path needed_helper(std::string_view name, std::string_view what_it_does);

}  // namespace waymark::tools
