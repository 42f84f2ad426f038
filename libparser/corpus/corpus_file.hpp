// Files of a corpus: bytes, their checksum, and lines that hold one JSON object each.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::parser {

std::string read_corpus_file(const std::filesystem::path& file);                    // throws ltl::FormatError
std::vector<std::filesystem::path> map_files(const std::filesystem::path& corpus);  // maps/*.json, by name
std::uint64_t fnv1a(std::string_view bytes);                                        // the checksum FNV-1a, 64 bits

// visit(line, number) for every line that is not blank; numbers count from 1.
template <typename Visit>
void each_line(std::string_view text, Visit visit) {
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t newline = text.find('\n', begin);
    const std::size_t end = newline == std::string_view::npos ? text.size() : newline;
    const std::string_view line = text.substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) visit(line, number);
    begin = end + 1;
  }
}

}  // namespace waymark::parser
