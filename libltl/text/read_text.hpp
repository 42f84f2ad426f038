// Texts that come in, with bounds: a file that never ends, or that cannot be read to its end, is an error and not the
// end of a text. A byte order mark at the beginning is dropped.
#pragma once
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::ltl {

inline constexpr std::size_t most_file_bytes = std::size_t{1} << 30U;  // 1 GiB
inline constexpr std::size_t most_line_bytes = std::size_t{1} << 24U;  // 16 MiB

// Both throw FormatError, naming the source: it cannot be read, is a directory, or has more bytes.
std::string read_text(const std::filesystem::path& file, std::size_t most = most_file_bytes);
std::string read_text(std::istream& in, std::string_view source, std::size_t most = most_file_bytes);

// For reading. Throws FormatError where the file is a directory or socket, or cannot be opened.
std::ifstream open_text(const std::filesystem::path& file);

// Line by line, in constant memory but for the line.
class LineReader {
 public:
  LineReader(std::istream& in, std::string source) : in_(in), source_(std::move(source)) {}
  // The next line without its end, LF or CR LF; false at the end of the text. Throws FormatError with the number of the
  // line: it cannot be read, or is longer than most_line_bytes. Nothing is read behind such a line.
  bool next(std::string& line);
  std::size_t number() const { return number_; }  // of the line that was read, from 1

 private:
  std::istream& in_;
  std::string source_;
  std::size_t number_ = 0;
  bool broken_ = false;
  std::vector<char> block_;
};

}  // namespace waymark::ltl
