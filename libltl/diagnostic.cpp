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

// The invalid byte or the character that begins at the offset, as utf8_length counts them.
std::size_t step(std::string_view text, std::size_t at) { return std::max<std::size_t>(1, utf8_character(text, at)); }

// Where the character with that number begins; the end when there are fewer.
std::size_t offset_of(std::string_view text, std::size_t character) {
  std::size_t at = 0;
  for (; at < text.size() && character > 0; --character) at += step(text, at);
  return at;
}

// C0, DEL, and C1, which is written in two bytes.
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20 || first == 0x7F || (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

// Each control character is one blank and each invalid byte U+FFFD, so that the caret stands where it should.
std::string visible(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); at += step(text, at)) {
    const std::string_view character = text.substr(at, utf8_character(text, at));
    if (character.empty())
      out += "\xEF\xBF\xBD";
    else
      out += is_control(character) ? " " : character;
  }
  return out;
}

// A message may quote what was read, which may be long and hold anything.
std::string bounded(std::string_view message) {
  constexpr std::size_t most = 1'000;
  const std::string_view kept = message.substr(0, offset_of(message.substr(0, 4 * most), most));
  return printable(kept) + (kept.size() < message.size() ? "…" : "");
}

std::string render(std::string_view text, Span where, std::string_view message, std::string_view source,
                   std::size_t first_line) {
  const Place place = locate(text, where.begin);
  const std::string number = std::to_string(place.line + first_line - 1);
  std::string out = bounded(message);
  if (!source.empty()) out += "\n  " + printable(source) + ":" + number + ":" + std::to_string(place.column);
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
  out += "\n  " + (source.empty() ? "input" : printable(source));
  if (line > 0) out += ":" + std::to_string(line);
  if (line > 0 && column > 0) out += ":" + std::to_string(column);
  return out;
}

}  // namespace

std::size_t utf8_character(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U; };
  const auto continues = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return at < text.size() ? 1 : 0;
  if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF)  // no overlong forms, no surrogates
    return continues(1, lead == 0xE0 ? 0xA0 : 0x80, lead == 0xED ? 0x9F : 0xBF) && continues(2) ? 3 : 0;
  if (lead >= 0xF0 && lead <= 0xF4)
    return continues(1, lead == 0xF0 ? 0x90 : 0x80, lead == 0xF4 ? 0x8F : 0xBF) && continues(2) && continues(3) ? 4 : 0;
  return 0;
}

std::size_t utf8_length(std::string_view text) {
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); at += step(text, at)) ++characters;
  return characters;
}

std::string printable(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view character = text.substr(at, step(text, at));
    at += character.size();
    if (character == "\n" || (utf8_character(character, 0) > 0 && !is_control(character))) {
      out += character;
      continue;
    }
    for (const char c : character) {
      const auto value = static_cast<unsigned char>(c);
      out += {'\\', 'x', digits[value >> 4U], digits[value & 15U]};
    }
  }
  return out;
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
