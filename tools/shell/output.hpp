// Files written whole or not at all, or standard output.
#pragma once
#include <filesystem>
#include <string_view>

namespace waymark::tools {

// As parser::write_file; "-" is standard output.
void write_file(const std::filesystem::path& path, std::string_view contents);

// Away with a file that an earlier export left, if there is one: what is read together is written together. Throws
// ltl::FormatError.
void remove_file(const std::filesystem::path& path);

// The directory, and those it lies in, where they are not there yet. Throws ltl::FormatError.
void make_directory(const std::filesystem::path& path);

// Throws the same where write_file could not succeed, as far as it can be told: before the work, not after it. Empty:
// nothing to write.
void check_writable(const std::filesystem::path& path);

}  // namespace waymark::tools
