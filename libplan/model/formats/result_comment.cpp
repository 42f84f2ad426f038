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

}  // namespace

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
