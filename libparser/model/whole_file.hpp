// Files written whole or not at all: to a temporary name beside the target, then renamed. Two processes that write one
// file leave one whole file.
#pragma once
#include <filesystem>
#include <string_view>

namespace waymark::parser {

// Replaces the file at `path`, and keeps its mode; a symbolic link stays one; a device or pipe is written directly.
// Throws ltl::FormatError naming the path and the reason when that fails; the old file is then untouched.
void write_file(const std::filesystem::path& path, std::string_view contents);

// Removes the temporary files of writes that are under way: for a process that is about to be ended.
void discard_unfinished_files();

}  // namespace waymark::parser
