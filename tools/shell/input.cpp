#include "tools/shell/input.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

std::unique_ptr<std::istream> open(const std::string& path) {
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) throw ltl::FormatError(path, 0, 0, "cannot read the file: " + std::string(std::strerror(errno)));
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw ltl::FormatError(path, 0, 0, "is a directory, not a file");
  return file;
}

bool passed_over(const std::string& line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string::npos || line[first] == '#';
}

}  // namespace

std::string source_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string read_file(const std::string& path) {
  const auto file = path == "-" ? nullptr : open(path);
  std::istream& in = file ? *file : std::cin;
  return ltl::read_text(in, source_name(path));
}

TextReader::TextReader(TextOptions options, const std::string& what) : arguments_(std::move(options.arguments)) {
  const bool dash = arguments_.size() == 1 && arguments_[0] == "-";
  if (!options.file.empty() && !arguments_.empty())
    throw UsageError("give the " + what + " as an argument or with -F, not both");
  if (options.file.empty() && !dash && !arguments_.empty()) return;
  if (options.file.empty() && !dash && ::isatty(STDIN_FILENO) != 0)
    throw UsageError("no " + what + ": give it as an argument, with -F FILE, or on standard input");
  arguments_.clear();
  const std::string path = options.file.empty() ? "-" : options.file;
  source_ = source_name(path);
  if (path != "-") file_ = open(path);
  lines_.emplace(file_ ? *file_ : std::cin, source_);
  std::cin.tie(nullptr);  // else who reads would flush std::cout, which another thread is writing to
}

TextReader::~TextReader() = default;

std::size_t TextReader::count() const {
  if (!lines_) return arguments_.size();
  if (!file_) throw UsageError("a share of standard input cannot be told: give a file");
  const auto again = open(source_);
  ltl::LineReader lines(*again, source_);
  std::size_t count = 0;
  for (std::string line; lines.next(line);)
    if (!passed_over(line)) ++count;
  return count;
}

std::optional<Text> TextReader::next() {
  if (!lines_) {
    if (argument_ == arguments_.size()) return std::nullopt;
    const std::size_t number = ++argument_;
    return Text{arguments_[number - 1], "", number};
  }
  for (std::string line; lines_->next(line);)
    if (!passed_over(line)) return Text{std::move(line), source_, lines_->number()};
  return std::nullopt;
}

}  // namespace waymark::tools
