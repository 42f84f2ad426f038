// Diagnostics: error messages about input, with a position.
//
// There are two kinds. A SyntaxError is about a text in one of our small languages (formulas, guards) and has the wrong
// span. A FormatError is about a file that violates its format. Both are printed as
//
//   error: expected a formula after 'U'
//     tour.ltl:1:12
//     1 | F (sofa U  )
//       |            ^
//
// with columns counted in UTF-8 characters, not bytes. Messages quote what was read; what() is printable all the same.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace waymark::ltl {

struct Span {  // bytes of the text, half open
  // The bytes begin … end − 1.
  std::size_t begin = 0;
  std::size_t end = 0;
};

class SyntaxError : public std::runtime_error {  // a text that cannot be read, with the span that is wrong
 public:
  // text: the whole input; where: the offending bytes; message: what was expected ("expected a formula after 'U'").
  // source: file name or "" for the command line; first_line: the number of the text's first line in that file.
  SyntaxError(std::string_view text, Span where, std::string_view message, std::string_view source = "",
              std::size_t first_line = 1);
  const std::string& message() const { return message_; }
  std::size_t line() const { return line_; }      // 1-based
  std::size_t column() const { return column_; }  // 1-based, in UTF-8 characters
  Span where() const { return where_; }
  // The same error about the same text, now known to come from `source`, starting at line `first_line`.
  SyntaxError in(std::string_view source, std::size_t first_line) const;

 private:
  std::string text_, message_;
  Span where_;
  std::size_t line_, column_;
};

class FormatError : public std::runtime_error {  // a file that violates its format
 public:
  // line and column are 1-based; 0 means "the file as a whole".
  FormatError(std::string_view source, std::size_t line, std::size_t column, std::string_view message);
  std::size_t line() const { return line_; }
  std::size_t column() const { return column_; }

 private:
  std::size_t line_, column_;
};

// Bytes of the UTF-8 character that begins at the offset: 1 to 4, or 0 where none does. Overlong forms and surrogates
// are no characters.
std::size_t utf8_character(std::string_view text, std::size_t at);

// Number of UTF-8 characters in the text (invalid bytes count one each). O(|text|).
std::size_t utf8_length(std::string_view text);

// The text without what could steer a terminal: control characters other than the line end (C0, DEL and C1), and bytes
// that are no UTF-8, become \xHH. printable(printable(t)) = printable(t).
std::string printable(std::string_view text);

}  // namespace waymark::ltl
