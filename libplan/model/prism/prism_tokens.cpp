#include "libplan/model/prism/prism_tokens.hpp"

#include "libltl/text/character.hpp"
#include "libplan/model/prism/prism_names.hpp"

namespace waymark::plan {
using ltl::is_digit, ltl::is_letter;
namespace {

std::size_t end_of_number(std::string_view text, std::size_t at) {
  const auto digits = [&] {
    while (at < text.size() && is_digit(text[at])) ++at;
  };
  const auto digit_at = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
  digits();
  if (at < text.size() && text[at] == '.' && digit_at(at + 1)) {  // 0..9 is a range
    ++at;
    digits();
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+') ? 1 : 0;
    if (digit_at(at + 1 + sign)) {
      at += 1 + sign;
      digits();
    }
  }
  return at;
}

std::size_t symbol_length(std::string_view rest) {
  for (std::string_view symbol : {"<=>", "->", "..", "=>", "<=", ">=", "!="})
    if (rest.starts_with(symbol)) return symbol.size();
  return std::string_view("[](){}:;=<>&|!+-*/?,'").find(rest[0]) == std::string_view::npos ? 0 : 1;
}

}  // namespace

std::vector<PrismToken> prism_tokens(std::string_view text, std::string_view source) {
  using Kind = PrismToken::Kind;
  std::vector<PrismToken> out;
  std::size_t at = 0;
  const auto add = [&](Kind kind, std::size_t end) {
    out.push_back({kind, text.substr(at, end - at), {at, end}});
    at = end;
  };
  while (at < text.size()) {
    const char c = text[at];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at;
    } else if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (is_letter(c)) {
      std::size_t end = at;
      while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
      add(Kind::Name, end);
    } else if (is_digit(c) || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]))) {  // .5 is 0.5
      add(Kind::Number, end_of_number(text, at));
    } else if (c == '"') {
      const std::size_t end = text.find('"', at + 1);
      if (end == std::string_view::npos) throw ltl::SyntaxError(text, {at, at + 1}, "a string without an end", source);
      out.push_back({Kind::String, text.substr(at + 1, end - at - 1), {at, end + 1}});
      at = end + 1;
    } else if (const std::size_t length = symbol_length(text.substr(at)); length > 0) {
      add(Kind::Symbol, at + length);
    } else {
      throw ltl::SyntaxError(text, {at, at + 1}, "a character that the language does not have", source);
    }
  }
  out.push_back({Kind::End, {}, {text.size(), text.size()}});
  return out;
}

bool PrismTokens::is(std::string_view word, std::size_t ahead) const {
  const PrismToken& token = peek(ahead);
  return (token.kind == PrismToken::Kind::Symbol || token.kind == PrismToken::Kind::Name) && token.text == word;
}
bool PrismTokens::accept(std::string_view word) {
  if (!is(word)) return false;
  next();
  return true;
}
const PrismToken& PrismTokens::expect(std::string_view word) {
  if (!is(word)) fail("expected '" + std::string(word) + "'");
  return next();
}
const PrismToken& PrismTokens::expect_name(std::string_view what) {
  if (peek().kind != PrismToken::Kind::Name || is_prism_reserved(peek().text))
    fail("expected the name of " + std::string(what));
  return next();
}
std::exception_ptr PrismTokens::error(ltl::Span where, const std::string& message) const {
  return std::make_exception_ptr(ltl::SyntaxError(text_, where, message, source_));
}

}  // namespace waymark::plan
