// Formulas over a, b, c, … with other names.
#pragma once
#include <cctype>
#include <functional>
#include <string>

namespace waymark::testing {

// The text of a formula with name(c) in the place of every proposition that is one small letter c.
inline std::string with_letters(const std::string& text, const std::function<std::string(char)>& name) {
  const auto in_word = [&](std::size_t i) {
    return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
  };
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool alone = !in_word(i + 1) && (i == 0 || !in_word(i - 1));
    if (alone && text[i] >= 'a' && text[i] <= 'z')
      out += name(text[i]);
    else
      out += text[i];
  }
  return out;
}

}  // namespace waymark::testing
