#include "tools/shell/json.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace waymark::tools {
namespace {

// Length of the well-formed UTF-8 character that the text begins with, 0 when it begins with none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continues = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF)  // no overlong forms, no surrogates
    return continues(1, lead == 0xE0 ? 0xA0 : 0x80, lead == 0xED ? 0x9F : 0xBF) && continues(2) ? 3 : 0;
  if (lead >= 0xF0 && lead <= 0xF4)
    return continues(1, lead == 0xF0 ? 0x90 : 0x80, lead == 0xF4 ? 0x8F : 0xBF) && continues(2) && continues(3) ? 4 : 0;
  return 0;
}

std::string control_character(char c) {
  switch (c) {
    case '\n': return "\\n";
    case '\t': return "\\t";
    case '\r': return "\\r";
    default: break;
  }
  constexpr std::string_view digits = "0123456789abcdef";
  const auto value = static_cast<unsigned char>(c);
  return std::string("\\u00") + digits[value >> 4U] + digits[value & 15U];
}

std::string quoted(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const char c = text.front();
    if (length == 0)
      out += "\xEF\xBF\xBD";  // U+FFFD: JSON is UTF-8 whatever was typed
    else if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      out += control_character(c);
    else
      out += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out + '"';
}

void insert(std::string& container, const std::string& item) {
  container.insert(container.size() - 1, (container.size() > 2 ? "," : "") + item);
}

}  // namespace

Json::Json(std::string_view value) : text_(quoted(value)) {}

Json::Json(double value) {
  if (!std::isfinite(value)) {
    text_ = std::isnan(value) ? "null" : value > 0 ? "\"inf\"" : "\"-inf\"";
    return;
  }
  std::array<char, 40> buffer{};
  text_.assign(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

JsonObject& JsonObject::add(std::string_view key, const Json& value) {
  insert(text_, quoted(key) + ':' + value.text());
  return *this;
}

JsonArray& JsonArray::add(const Json& value) {
  insert(text_, value.text());
  return *this;
}

}  // namespace waymark::tools
