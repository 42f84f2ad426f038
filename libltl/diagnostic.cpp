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

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }  // within a character of UTF-8

// Where the character with that number begins; the end when there are fewer.
std::size_t offset_of(std::string_view text, std::size_t character) {
  std::size_t at = 0;
  for (; at < text.size() && character > 0; --character) do
      ++at;
    while (at < text.size() && continues(text[at]));
  return at;
}

// Tabs would move the caret, and a NUL would end the message: each control character is shown as one blank.
std::string visible(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return out;
}

// A message may quote what was read, which may be long and hold anything.
std::string bounded(std::string_view message) {
  constexpr std::size_t most = 1'000;
  std::string out(message.substr(0, offset_of(message.substr(0, 4 * most), most)));
  if (out.size() < message.size()) out += "…";
  std::replace(out.begin(), out.end(), '\0', ' ');
  return out;
}

std::string render(std::string_view text, Span where, std::string_view message, std::string_view source,
                   std::size_t first_line) {
  const Place place = locate(text, where.begin);
  const std::string number = std::to_string(place.line + first_line - 1);
  std::string out = bounded(message);
  if (!source.empty()) out += "\n  " + std::string(source) + ":" + number + ":" + std::to_string(place.column);
  const auto last = std::min(where.end, where.begin + place.line_text.size());
  const auto width = where.end > where.begin ? utf8_length(text.substr(where.begin, last - where.begin)) : 1;
  // Of a long line, what stands around the place.
  constexpr std::size_t most_columns = 200, before = 60;
  std::string_view shown = place.line_text;
  std::size_t column = place.column - 1;
  const char *cut_left = "", *cut_right = "";
  if (utf8_length(shown) > most_columns) {
    const std::size_t skipped = column > before ? column - before : 0;
    shown.remove_prefix(offset_of(shown, skipped));
    column -= skipped;
    if (skipped > 0) cut_left = "…", ++column;
    const std::size_t kept = offset_of(shown, most_columns);
    if (kept < shown.size()) cut_right = "…";
    shown = shown.substr(0, kept);
  }
  out += "\n  " + number + " | " + cut_left + visible(shown) + cut_right;
  const std::size_t room = std::max<std::size_t>(utf8_length(shown) + 2, column + 1) - column;
  out += "\n  " + std::string(number.size(), ' ') + " | " + std::string(column, ' ') +
         std::string(std::clamp<std::size_t>(width, 1, room), '^');
  return out;
}

std::string at(std::string_view source, std::size_t line, std::size_t column, std::string_view message) {
  std::string out = bounded(message);
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
