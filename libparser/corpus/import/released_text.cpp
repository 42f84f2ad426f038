#include "libparser/corpus/import/released_text.hpp"

#include <algorithm>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Bytes of the well-formed character that the text begins with (no surrogates, nothing overlong); 0: it begins with
// none.
std::size_t character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || (first == 0xF0 && second < 0x90) ||
      (first == 0xF4 && second > 0x8F))
    return 0;
  return std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), continues) ? length : 0;
}

std::size_t first_fault(std::string_view text) {  // text.size(): there is none
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = character(text.substr(at));
    if (length == 0) break;
    at += length;
  }
  return at;
}

bool declares_latin1(std::string_view text) {
  if (text.substr(0, 5) != "<?xml") return false;
  std::string declaration(text.substr(0, text.find("?>")));
  for (char& c : declaration)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return declaration.find("iso-8859-1") != std::string::npos || declaration.find("latin1") != std::string::npos;
}

std::string from_latin1(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xC0U | (byte >> 6U));
      out += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return out;
}

}  // namespace

std::string released_text(std::string bytes, std::string_view file) {
  if (declares_latin1(bytes)) return from_latin1(bytes);
  if (bytes.rfind("\xEF\xBB\xBF", 0) == 0) bytes.erase(0, 3);
  const std::size_t fault = first_fault(bytes);
  if (fault < bytes.size()) {
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(fault);
    throw ltl::FormatError(file, 1 + static_cast<std::size_t>(std::count(bytes.begin(), end, '\n')), 0, "is not UTF-8");
  }
  return bytes;
}

}  // namespace waymark::parser
