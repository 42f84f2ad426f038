#include "libplan/model/formats/result_comment.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace waymark::plan {
namespace {

std::optional<double> number(std::string_view text) {
  double out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

bool is_about(std::string_view text, const PrismConstants& constants) {  // "(N=2, K=4)", or nothing
  std::string rest;
  for (const char c : text)
    if (std::string_view(" \t()").find(c) == std::string_view::npos) rest += c;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(','), rest.size()), equals = rest.find('=');
    if (equals >= end) return false;
    const auto given = constants.find(rest.substr(0, equals));
    if (given != constants.end() && given->second != rest.substr(equals + 1, end - equals - 1)) return false;
    rest.erase(0, end + 1);
  }
  return true;
}

}  // namespace

std::optional<std::string> result_before(std::string_view comments, const PrismConstants& constants) {
  constexpr std::string_view word = "RESULT";
  for (std::size_t at = comments.find(word); at != std::string_view::npos; at = comments.find(word, at + 1)) {
    const std::string_view line = comments.substr(at + word.size(), comments.find('\n', at) - at - word.size());
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_about(line.substr(0, colon), constants)) continue;
    std::string value(line.substr(colon + 1));
    value.erase(0, value.find_first_not_of(" \t"));
    value.erase(value.find_last_not_of(" \t\r") + 1);
    return value;
  }
  return std::nullopt;
}

std::optional<bool> agrees(const std::string& result, double value, std::optional<bool> verdict,
                           std::optional<double> range) {
  if (expects_error(result)) return false;
  if (result == "true" || result == "false")
    return verdict ? std::optional<bool>(*verdict == (result == "true")) : std::nullopt;
  if (result.starts_with("[") && result.ends_with("]") && result.find(',') != std::string::npos) {
    const std::size_t comma = result.find(',');
    const std::optional<double> from = number(result.substr(1, comma - 1));
    const std::optional<double> to = number(result.substr(comma + 1, result.size() - comma - 2));
    if (!range && from && to && *from < value && value < *to) return true;
    const auto least = agrees(result.substr(1, comma - 1), value, {}, {});
    const auto most = agrees(result.substr(comma + 1, result.size() - comma - 2), range.value_or(value), {}, {});
    return least && most ? std::optional<bool>(*least && *most) : std::nullopt;
  }
  if (result == "Infinity" || result == "Inf") return value == INFINITY;
  const std::size_t slash = result.find('/');
  std::optional<double> expected = number(result.substr(0, slash));
  if (slash != std::string::npos && expected) {
    const std::optional<double> below = number(result.substr(slash + 1));
    expected = below ? std::optional<double>(*expected / *below) : std::nullopt;
  }
  if (!expected) return std::nullopt;
  return std::abs(value - *expected) <= std::max(1e-5 * std::abs(*expected), 1e-7);
}

}  // namespace waymark::plan
