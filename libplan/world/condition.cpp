#include "libplan/world/condition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace waymark::plan {
namespace {

struct Sign {
  std::string_view text;
  Comparison comparison;
};

// Longer signs before their own prefixes.
constexpr std::array<Sign, 11> signs{{
    {">=", Comparison::AtLeast},
    {"<=", Comparison::AtMost},
    {"==", Comparison::Equal},
    {"!=", Comparison::NotEqual},
    {"<>", Comparison::NotEqual},
    {"≥", Comparison::AtLeast},
    {"≤", Comparison::AtMost},
    {"≠", Comparison::NotEqual},
    {"=", Comparison::Equal},
    {"<", Comparison::Less},
    {">", Comparison::Greater},
}};

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::optional<Condition> condition_of(std::string_view name) {
  for (std::size_t at = 0; at < name.size(); ++at)
    for (const Sign& sign : signs) {
      if (!name.substr(at).starts_with(sign.text)) continue;
      const std::string_view column = without_blanks(name.substr(0, at)),
                             value = without_blanks(name.substr(at + sign.text.size()));
      if (column.empty() || value.empty()) return std::nullopt;
      return Condition{std::string(column), sign.comparison, std::string(value), number_of(value)};
    }
  return std::nullopt;
}

std::optional<bool> holds(const Condition& condition, std::string_view cell) {
  const bool equality = condition.comparison == Comparison::Equal || condition.comparison == Comparison::NotEqual;
  if (!condition.number) {
    if (!equality) return std::nullopt;
    return (cell == condition.value) == (condition.comparison == Comparison::Equal);
  }
  const auto number = number_of(cell);
  if (!number) return std::nullopt;
  switch (condition.comparison) {
    case Comparison::Equal: return *number == *condition.number;
    case Comparison::NotEqual: return *number != *condition.number;
    case Comparison::Less: return *number < *condition.number;
    case Comparison::AtMost: return *number <= *condition.number;
    case Comparison::Greater: return *number > *condition.number;
    case Comparison::AtLeast: return *number >= *condition.number;
  }
  return std::nullopt;  // unreachable: -Werror=switch
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<bool> truth_of(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const std::string_view yes : {"1", "true", "yes", "on", "x", "t", "y", "1.0"})
    if (small == yes) return true;
  for (const std::string_view no : {"", "0", "false", "no", "off", "-", "f", "n", "0.0"})
    if (small == no) return false;
  return std::nullopt;
}

}  // namespace waymark::plan
