#include "libautomata/hoa/lexer.hpp"

#include "libltl/diagnostic.hpp"
#include "libltl/text/character.hpp"

namespace waymark::automata {
namespace {

using Kind = HoaToken::Kind;

using ltl::is_digit, ltl::is_letter;
bool is_name(char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '.'; }  // dots: version 1.1

}  // namespace

std::vector<HoaToken> HoaLexer::automaton() {
  std::vector<HoaToken> out;
  do {
    blanks();
    out.push_back(token());
  } while (out.back().kind != Kind::Eof && out.back().kind != Kind::End && out.back().kind != Kind::Abort);
  return out;
}

void HoaLexer::fail(std::string_view message) const { throw ltl::FormatError(source_, line_, column_, message); }

void HoaLexer::advance(std::size_t bytes) {
  for (; bytes > 0 && more(); --bytes, ++at_) {
    if (text_[at_] == '\n') {
      ++line_;
      column_ = 1;
    } else if (at_ + 1 >= text_.size() || (static_cast<unsigned char>(text_[at_ + 1]) & 0xC0U) != 0x80U) {
      ++column_;  // the last byte of a UTF-8 character
    }
  }
}

void HoaLexer::blanks() {
  while (more()) {
    const char c = text_[at_];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      advance(1);
    } else if (looking_at("/*")) {
      comment();
    } else {
      return;
    }
  }
}

void HoaLexer::comment() {
  const HoaLexer opening = *this;
  std::size_t depth = 0;
  do {
    if (!more()) opening.fail("this comment does not end");
    const bool opens = looking_at("/*"), closes = looking_at("*/");
    depth += opens ? 1 : 0;
    depth -= closes ? 1 : 0;
    advance(opens || closes ? 2 : 1);
  } while (depth > 0);
}

HoaToken HoaLexer::token() {
  HoaToken out{Kind::Eof, {}, 0, line_, column_};
  if (!more()) return out;
  const std::size_t begin = at_;
  const char c = text_[at_];
  if (c == '"') {
    out.kind = Kind::String;
    string();
  } else if (is_digit(c)) {
    out.kind = Kind::Integer;
    out.value = integer();
  } else if (is_letter(c)) {
    while (more() && is_name(text_[at_])) advance(1);
    out.kind = more() && text_[at_] == ':' ? Kind::Header : Kind::Identifier;
  } else if (c == '@') {
    out.kind = Kind::Alias;
    advance(1);
    while (more() && is_name(text_[at_])) advance(1);
    if (at_ == begin + 1) fail("expected the name of an alias after '@'");
  } else if (c == '-') {
    out.kind = marker();
  } else if (std::string_view("[](){}!&|").find(c) != std::string_view::npos) {
    out.kind = Kind::Punctuation;
    advance(1);
  } else {
    fail("this character has no place in a HOA file");
  }
  out.text = text_.substr(begin, at_ - begin);
  if (out.kind == Kind::Header) advance(1);
  return out;
}

void HoaLexer::string() {
  const HoaLexer opening = *this;
  advance(1);
  while (more() && text_[at_] != '"') advance(text_[at_] == '\\' ? 2 : 1);
  if (!more()) opening.fail("this string does not end");
  advance(1);
}

std::uint64_t HoaLexer::integer() {
  std::uint64_t value = 0;
  for (std::size_t digits = 0; more() && is_digit(text_[at_]); advance(1), ++digits) {
    if (digits > 0 && value == 0) fail("a number does not begin with 0");
    if (digits >= 18) fail("this number is too large");
    value = 10 * value + static_cast<std::uint64_t>(text_[at_] - '0');
  }
  return value;
}

Kind HoaLexer::marker() {
  for (const auto& [word, kind] : {std::pair<std::string_view, Kind>{"--BODY--", Kind::Body},
                                   {"--END--", Kind::End},
                                   {"--ABORT--", Kind::Abort}}) {
    if (!looking_at(word)) continue;
    advance(word.size());
    return kind;
  }
  fail("expected --BODY--, --END-- or --ABORT--");
}

std::string unquoted(std::string_view quoted) {
  std::string out;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\' && i + 2 < quoted.size()) ++i;
    out += quoted[i];
  }
  return out;
}

std::string described(const HoaToken& token) {
  if (token.kind == Kind::Eof) return "the end of the file";
  constexpr std::size_t longest = 40;
  std::string shown(token.text.substr(0, longest));
  if (token.text.size() > longest) shown += "…";
  return "'" + shown + (token.kind == Kind::Header ? ":'" : "'");
}

}  // namespace waymark::automata
