#include "tools/shell/rounded.hpp"

#include <array>
#include <cfenv>
#include <cstdio>

namespace waymark::tools {
namespace {

// printf rounds as the floating-point environment says.
std::string rounded(double number, int digits, int direction) {
  const int before = std::fegetround();
  std::fesetround(direction);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  std::fesetround(before);
  return text.data();
}

}  // namespace

std::string between(double lower, double upper, int digits) {
  return "in [" + rounded(lower, digits, FE_DOWNWARD) + ", " + rounded(upper, digits, FE_UPWARD) + ']';
}

}  // namespace waymark::tools
