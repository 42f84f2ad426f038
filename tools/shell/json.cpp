#include "tools/shell/json.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

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
    const std::size_t length = ltl::utf8_character(text, 0);
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
