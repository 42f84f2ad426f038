#include "tools/shell/input.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"
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
  what_ = what;
  if (path != "-") file_ = open(path);
  if (file_ && std::filesystem::is_regular_file(path)) {
    constexpr std::size_t most = std::size_t{1} << 16U;
    std::string beginning(most, '\0');
    file_->read(beginning.data(), static_cast<std::streamsize>(most));
    beginning.resize(static_cast<std::size_t>(file_->gcount()));
    file_->clear();
    file_->seekg(0);
    refuse_other_formats(beginning);
  }
  lines_.emplace(file_ ? *file_ : std::cin, source_);
  std::cin.tie(nullptr);  // else who reads would flush std::cout, which another thread is writing to
}

TextReader::~TextReader() = default;

// Nothing is read behind it, whoever asks next.
void TextReader::refuse_other_formats(std::string_view beginning) {
  refused_ = true;
  ltl::refuse_foreign(beginning, source_, "one " + what_ + " a line");
  refused_ = false;
}

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
  for (std::string line; !refused_ && lines_->next(line);) {
    if (passed_over(line)) continue;
    if (!any_line_) refuse_other_formats(line);
    any_line_ = true;
    return Text{std::move(line), source_, lines_->number()};
  }
  return std::nullopt;
}

}  // namespace waymark::tools
