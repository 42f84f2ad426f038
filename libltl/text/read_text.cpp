#include "libltl/text/read_text.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "libltl/diagnostic.hpp"

namespace waymark::ltl {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

[[noreturn]] void fail(std::string_view source, std::size_t line, const std::string& message) {
  throw FormatError(source, line, 0, message);
}

std::string bytes(std::size_t n) { return std::to_string(n >> 20U) + " MiB"; }

}  // namespace

std::string read_text(std::istream& in, std::string_view source, std::size_t most) {
  std::string text;
  std::array<char, std::size_t{1} << 16U> block{};
  do {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto got = static_cast<std::size_t>(in.gcount());
    if (got > most - text.size()) fail(source, 0, "expected at most " + bytes(most));
    text.append(block.data(), got);
  } while (in);
  if (in.bad()) fail(source, 0, "cannot be read to its end");
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

std::ifstream open_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) fail(file.string(), 0, "is a directory, not a file");
  if (std::filesystem::is_socket(file, ignored)) fail(file.string(), 0, "is a socket, not a file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    fail(file.string(), 0, "cannot read the file" + (errno != 0 ? ": " + std::string(std::strerror(errno)) : ""));
  return in;
}

std::string read_text(const std::filesystem::path& file, std::size_t most) {
  std::ifstream in = open_text(file);
  return read_text(in, file.string(), most);
}

bool LineReader::next(std::string& line) {
  line.clear();
  if (broken_) return false;
  block_.resize(std::size_t{1} << 12U);
  while (true) {
    in_.getline(block_.data(), static_cast<std::streamsize>(block_.size()));
    auto got = static_cast<std::size_t>(in_.gcount());
    broken_ = in_.bad() || got > most_line_bytes - line.size();
    if (in_.bad()) fail(source_, number_ + 1, "cannot be read: the text may be cut here");
    if (broken_) fail(source_, number_ + 1, "expected at most " + bytes(most_line_bytes) + " on a line");
    const bool ended = !in_.eof() && !in_.fail();  // at an LF, which gcount counts
    if (ended) --got;
    line.append(block_.data(), got);
    if (ended) break;
    if (in_.eof()) {
      if (line.empty()) return false;
      break;
    }
    in_.clear();  // the block was full
  }
  if (++number_ == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

}  // namespace waymark::ltl
