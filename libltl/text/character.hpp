// Characters of names and numbers in every text that is read: ASCII alone, whatever the locale.
#pragma once

namespace waymark::ltl {

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }  // 0 … 9

}  // namespace waymark::ltl
