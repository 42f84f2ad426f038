// The sources of formulas and instructions: arguments, a file with one text a line, or standard input.
#pragma once
#include <cstddef>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libltl/text/read_text.hpp"

namespace waymark::tools {

struct TextOptions {
  std::vector<std::string> arguments;  // one text each; "-" alone: standard input
  std::string file;                    // -F FILE, "-": standard input
};

struct Text {
  std::string text;
  std::string source;    // for messages: the file, "standard input", or "" for the command line
  std::size_t line = 1;  // in that source, counted from 1; of arguments, which of them
};

// Reads texts one at a time, so that a pipe is answered line by line. Of files and standard input, blank lines and
// lines beginning with # are passed over; line numbers count them.
class TextReader {
 public:
  // Without arguments and file, standard input is read unless it is a terminal: then UsageError, saying `what` is
  // missing. A file in a format of another kind is a FormatError that names the format.
  TextReader(TextOptions options, const std::string& what);
  ~TextReader();
  std::optional<Text> next();
  // How many texts there are, those that were read among them: the file is read once more. Throws UsageError when they
  // come from standard input.
  std::size_t count() const;
  bool is_batch() const { return lines_.has_value() || arguments_.size() > 1; }
  const std::string& source() const { return source_; }

 private:
  void refuse_other_formats(std::string_view beginning);

  std::vector<std::string> arguments_;
  std::size_t argument_ = 0;
  std::unique_ptr<std::istream> file_;
  std::string source_, what_;
  bool any_line_ = false, refused_ = false;
  std::optional<ltl::LineReader> lines_;  // nothing: arguments
};

// The whole file, or standard input for "-". Throws ltl::FormatError naming the path and the reason.
std::string read_file(const std::string& path);

// The name that messages use for a path: "standard input" for "-".
std::string source_name(const std::string& path);

}  // namespace waymark::tools
