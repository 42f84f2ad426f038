#include "libplan/world/json_position.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace waymark::plan {
namespace {

// Walks over valid JSON without building anything; every function starts at the first byte of its value.
class Scanner {
 public:
  explicit Scanner(std::string_view json) : json_(json) {}

  std::size_t skip_space(std::size_t at) const {
    while (at < json_.size() && std::string_view(" \t\r\n").find(json_[at]) != std::string_view::npos) ++at;
    return at;
  }
  std::size_t end_of_string(std::size_t at) const {  // just behind the closing quote
    for (++at; at < json_.size() && json_[at] != '"'; ++at)
      if (json_[at] == '\\') ++at;
    return std::min(at + 1, json_.size());
  }
  std::size_t end_of_value(std::size_t at) const {  // iterative: documents may nest deeply
    std::size_t depth = 0;
    do {
      at = skip_space(at);
      if (at >= json_.size()) return at;
      const char c = json_[at];
      if (c == '"')
        at = end_of_string(at);
      else if (c == '[' || c == '{')
        ++depth, ++at;
      else if (c == ']' || c == '}')
        --depth, ++at;
      else if (c == ',' || c == ':')
        ++at;
      else
        at = std::min(json_.find_first_of(",:]} \t\r\n", at), json_.size());
    } while (depth > 0);
    return at;
  }
  // The value of the last member of that name in the object at `at`; keys with escapes are no names of ours.
  std::optional<std::size_t> member(std::size_t at, std::string_view name) const {
    std::optional<std::size_t> found;
    if (json_[at] != '{') return found;
    for (at = skip_space(at + 1); at < json_.size() && json_[at] == '"';) {
      const std::size_t key_end = end_of_string(at);
      const std::string_view key = json_.substr(at + 1, key_end - at - 2);
      const std::size_t value = skip_space(skip_space(key_end) + 1);
      if (key == name) found = value;
      at = skip_space(end_of_value(value));
      if (at < json_.size() && json_[at] == ',') at = skip_space(at + 1);
    }
    return found;
  }
  std::optional<std::size_t> element(std::size_t at, std::size_t index) const {
    if (json_[at] != '[') return std::nullopt;
    at = skip_space(at + 1);
    for (std::size_t i = 0; at < json_.size() && json_[at] != ']'; ++i) {
      if (i == index) return at;
      at = skip_space(end_of_value(at));
      if (at < json_.size() && json_[at] == ',') at = skip_space(at + 1);
    }
    return std::nullopt;
  }

 private:
  std::string_view json_;
};

}  // namespace

std::size_t offset_of(std::string_view json, std::string_view path) {
  const Scanner scanner(json);
  std::size_t at = scanner.skip_space(0);
  while (!path.empty() && at < json.size()) {
    std::optional<std::size_t> next;
    if (path.front() == '[') {
      const std::size_t close = path.find(']');
      if (close == std::string_view::npos) return at;  // a key that looks like the beginning of an index
      std::size_t index = 0;
      std::from_chars(path.data() + 1, path.data() + close, index);
      next = scanner.element(at, index);
      path.remove_prefix(close + 1);
    } else {
      if (path.front() == '.') path.remove_prefix(1);
      const std::size_t end = std::min(path.find_first_of(".["), path.size());
      next = scanner.member(at, path.substr(0, end));
      path.remove_prefix(end);
    }
    if (!next) return at;
    at = *next;
  }
  return at;
}

ltl::FormatError format_error(std::string_view source, std::string_view json, std::string_view path,
                              std::string_view message, std::size_t first_line) {
  const std::string text = path.empty() ? std::string(message) : std::string(path) + ": " + std::string(message);
  return format_error_at(source, json, offset_of(json, path), text, first_line);
}

ltl::FormatError format_error_at(std::string_view source, std::string_view text, std::size_t offset,
                                 std::string_view message, std::size_t first_line) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + first_line;
  const std::size_t newline = before.rfind('\n');
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  return ltl::FormatError(source, line, ltl::utf8_length(before.substr(begin)) + 1, message);
}

}  // namespace waymark::plan
