// Files written whole or not at all: to a temporary name beside the target, then renamed.
#pragma once
#include <filesystem>
#include <string_view>

namespace waymark::tools {

// Replaces the file at `path`; "-" is standard output; a device or pipe is written directly.
// Throws ltl::FormatError naming the path and the reason when that fails; the old file is then untouched.
void write_file(const std::filesystem::path& path, std::string_view contents);

// The directory, and those it lies in, where they are not there yet. Throws ltl::FormatError.
void make_directory(const std::filesystem::path& path);

// Throws the same where write_file could not succeed, as far as it can be told: before the work, not after it. Empty:
// nothing to write.
void check_writable(const std::filesystem::path& path);

// Removes the temporary files of writes that are under way: for a process that is about to be ended.
void discard_unfinished_files();

}  // namespace waymark::tools
