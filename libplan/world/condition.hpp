// Conditions on values: names of propositions that compare a column of a table with a constant, such as "x >= 3".
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace waymark::plan {

enum class Comparison : std::uint8_t { Equal, NotEqual, Less, AtMost, Greater, AtLeast };  // = != < <= > >=

struct Condition {               // column ∘ value
  std::string column;            // not empty
  Comparison comparison = {};    // ∘
  std::string value;             // a number, or a text, which is compared by = and != only
  std::optional<double> number;  // of a number
};

// Nothing when the name compares nothing. == is =, ≠ ≤ ≥ are read too.
std::optional<Condition> condition_of(std::string_view name);

// Nothing when the cell cannot be compared: it is no number, and the value is one or the comparison asks for it.
std::optional<bool> holds(const Condition& condition, std::string_view cell);

std::optional<double> number_of(std::string_view text);  // the whole text, a finite number
// true, yes, on, 1, x and their likes, or false, no, off, 0, -, and nothing at all.
std::optional<bool> truth_of(std::string_view text);

}  // namespace waymark::plan
