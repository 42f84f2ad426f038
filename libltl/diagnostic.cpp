#include "libltl/diagnostic.hpp"

#include <algorithm>

namespace waymark::ltl {
namespace {

struct Place {
  std::size_t line, column;    // 1-based, relative to the text
  std::string_view line_text;  // without the line end
};

Place locate(std::string_view text, std::size_t offset) {
  offset = std::min(offset, text.size());
  const auto line =
      static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
  const auto newline = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  const auto begin = newline == std::string_view::npos ? 0 : newline + 1;
  const auto end = std::min(text.find('\n', begin), text.size());
  return {line + 1, utf8_length(text.substr(begin, offset - begin)) + 1, text.substr(begin, end - begin)};
}

std::string render(std::string_view text, Span where, std::string_view message, std::string_view source,
                   std::size_t first_line) {
  const Place place = locate(text, where.begin);
  const std::string number = std::to_string(place.line + first_line - 1);
  std::string out(message);
  if (!source.empty()) out += "\n  " + std::string(source) + ":" + number + ":" + std::to_string(place.column);
  // Tabs would move the caret: show them as one space.
  std::string shown(place.line_text);
  std::replace(shown.begin(), shown.end(), '\t', ' ');
  const auto last = std::min(where.end, where.begin + place.line_text.size());
  const auto width = where.end > where.begin ? utf8_length(text.substr(where.begin, last - where.begin)) : 1;
  out += "\n  " + number + " | " + shown;
  out += "\n  " + std::string(number.size(), ' ') + " | " + std::string(place.column - 1, ' ') +
         std::string(std::max<std::size_t>(width, 1), '^');
  return out;
}

std::string at(std::string_view source, std::size_t line, std::size_t column, std::string_view message) {
  std::string out(message);
  if (source.empty() && line == 0) return out;
  out += "\n  " + std::string(source.empty() ? "input" : source);
  if (line > 0) out += ":" + std::to_string(line);
  if (line > 0 && column > 0) out += ":" + std::to_string(column);
  return out;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

SyntaxError::SyntaxError(std::string_view text, Span where, std::string_view message, std::string_view source,
                         std::size_t first_line)
    : std::runtime_error(render(text, where, message, source, first_line)),
      text_(text),
      message_(message),
      where_(where),
      line_(locate(text, where.begin).line + first_line - 1),
      column_(locate(text, where.begin).column) {}

SyntaxError SyntaxError::in(std::string_view source, std::size_t first_line) const {
  return SyntaxError(text_, where_, message_, source, first_line);
}

FormatError::FormatError(std::string_view source, std::size_t line, std::size_t column, std::string_view message)
    : std::runtime_error(at(source, line, column, message)), line_(line), column_(column) {}

}  // namespace waymark::ltl
