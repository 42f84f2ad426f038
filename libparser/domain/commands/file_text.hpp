// The text of a file, for readers of JSON.
#pragma once
#include <filesystem>
#include <string>

namespace waymark::parser {

// Throws ltl::FormatError when the file cannot be read.
std::string text_of(const std::filesystem::path& file);

}  // namespace waymark::parser
