#include "libltl/text/lexer.hpp"

#include <algorithm>
#include <utility>

#include "libltl/text/character.hpp"

namespace waymark::ltl {
namespace {

struct Spelling {
  std::string_view text;
  Symbol symbol;
};

// Operators that are no words; longer spellings before their own prefixes.
constexpr Spelling spellings[] = {
    {"<->", Symbol::Iff},        {"<=>", Symbol::Iff},         {"<>", Symbol::Eventually}, {"->", Symbol::Implies},
    {"=>", Symbol::Implies},     {"&&", Symbol::And},          {"||", Symbol::Or},         {"/\\", Symbol::And},
    {"\\/", Symbol::Or},         {"[]", Symbol::Always},       {"()", Symbol::Next},       {"&", Symbol::And},
    {"|", Symbol::Or},           {"!", Symbol::Not},           {"~", Symbol::Not},         {"^", Symbol::ExclusiveOr},
    {"¬", Symbol::Not},          {"∧", Symbol::And},           {"∨", Symbol::Or},          {"⊕", Symbol::ExclusiveOr},
    {"⊻", Symbol::ExclusiveOr},  {"→", Symbol::Implies},       {"⇒", Symbol::Implies},     {"⟶", Symbol::Implies},
    {"⟹", Symbol::Implies},      {"↔", Symbol::Iff},           {"⇔", Symbol::Iff},         {"⟷", Symbol::Iff},
    {"⟺", Symbol::Iff},          {"≡", Symbol::Iff},           {"◇", Symbol::Eventually},  {"⋄", Symbol::Eventually},
    {"♢", Symbol::Eventually},   {"⬦", Symbol::Eventually},    {"⟡", Symbol::Eventually},  {"□", Symbol::Always},
    {"◻", Symbol::Always},       {"⬜", Symbol::Always},        {"○", Symbol::Next},        {"◯", Symbol::Next},
    {"●", Symbol::WeakNext},     {"⬤", Symbol::WeakNext},      {"𝒰", Symbol::Until},       {"ℛ", Symbol::Release},
    {"𝒲", Symbol::WeakUntil},    {"ℳ", Symbol::StrongRelease}, {"⊖", Symbol::Yesterday},   {"⊝", Symbol::WeakYesterday},
    {"◆", Symbol::Once},         {"⧫", Symbol::Once},          {"⟐", Symbol::Once},        {"■", Symbol::Historically},
    {"⊟", Symbol::Historically}, {"𝒮", Symbol::Since},         {"𝒯", Symbol::Triggered},
};

constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_identifier(std::string_view s) {
  return !s.empty() && is_letter(s[0]) &&
         std::all_of(s.begin(), s.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

std::optional<Symbol> unary_letter(char c) {
  switch (c) {
    case 'X': return Symbol::Next;
    case 'N': return Symbol::WeakNext;
    case 'F': return Symbol::Eventually;
    case 'G': return Symbol::Always;
    default: return std::nullopt;  // any other character
  }
}

std::optional<Symbol> binary_letter(char c) {
  switch (c) {
    case 'U': return Symbol::Until;
    case 'R':
    case 'V': return Symbol::Release;
    case 'W': return Symbol::WeakUntil;
    case 'M': return Symbol::StrongRelease;
    default: return std::nullopt;  // any other character
  }
}

// Alone, not in a run: XY and GO stay names.
std::optional<Symbol> past_letter(char c) {
  switch (c) {
    case 'Y': return Symbol::Yesterday;
    case 'Z': return Symbol::WeakYesterday;
    case 'O': return Symbol::Once;
    case 'H': return Symbol::Historically;
    case 'S': return Symbol::Since;
    case 'T': return Symbol::Triggered;
    default: return std::nullopt;  // any other character
  }
}

std::optional<Symbol> operator_word(std::string_view word, Notation notation, Dialect dialect) {
  if (word == "xor") return Symbol::ExclusiveOr;
  if (word == "WX") return Symbol::WeakNext;
  if (word.size() != 1) return std::nullopt;
  if (notation == Notation::Lbt && word == "i") return Symbol::Implies;
  if (notation == Notation::Lbt && word == "e") return Symbol::Iff;
  if (dialect == Dialect::Waymark)
    if (const auto past = past_letter(word[0])) return past;
  return binary_letter(word[0]);
}

std::optional<bool> constant_word(std::string_view word, Notation notation) {
  if (word == "true" || word == "tt" || (notation == Notation::Lbt && word == "t")) return true;
  if (word == "false" || word == "ff" || (notation == Notation::Lbt && word == "f")) return false;
  return std::nullopt;
}

// Where the character that begins at the offset ends; a byte that is no UTF-8 is one.
std::size_t character_end(std::string_view text, std::size_t at) {
  return at + std::max<std::size_t>(1, utf8_character(text, at));
}

bool is_unary_run(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char c) { return unary_letter(c).has_value(); });
}

}  // namespace

bool is_bare_name(std::string_view name, Notation notation) {
  return is_identifier(name) && !is_unary_run(name) && !operator_word(name, notation, Dialect::Waymark) &&
         !constant_word(name, notation);
}

void Lexer::fail(Span where, std::string_view message) const { throw SyntaxError(text_, where, message); }

void Lexer::skip_space() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

bool Lexer::take(std::string_view expected) {
  if (at_ == text_.size() || text_[at_] != expected.front()) return false;  // mostly, without a call
  if (text_.substr(at_, expected.size()) != expected) return false;
  at_ += expected.size();
  return true;
}

std::optional<std::size_t> Lexer::number() {
  constexpr std::size_t most = 1'000'000;  // beyond every bound that can be spelled out
  if (at_ == text_.size() || !is_digit(text_[at_])) return std::nullopt;
  std::size_t value = 0;
  for (; at_ < text_.size() && is_digit(text_[at_]); ++at_)
    value = std::min(most, 10 * value + static_cast<std::size_t>(text_[at_] - '0'));
  return value;
}

std::size_t Lexer::steps() {
  skip_space();
  const auto value = number();
  if (!value) fail({at_, at_}, "expected a number of steps");
  skip_space();
  return *value;
}

// <=k, [<=k], [i:j], [i,j] and [i:], or nothing.
void Lexer::bounds(Token& token) {
  const std::size_t end = at_;
  skip_space();
  if (take("[<=") || take("[≤")) {
    token.bound = steps();
    if (!take("]")) fail({at_, at_}, "expected ']' after the number of steps");
  } else if (text_.substr(at_, 3) != "<=>" && (take("<=") || take("≤"))) {
    token.bound = steps();
  } else if (at_ + 1 < text_.size() && text_[at_] == '[' && (is_digit(text_[at_ + 1]) || text_[at_ + 1] == ' ')) {
    const std::size_t begin = at_++;
    token.from = steps();
    if (!take(":") && !take(",") && !take("..")) fail({at_, at_}, "expected ':' and a second number of steps");
    skip_space();
    if (!take("]")) {
      token.bound = steps();
      if (!take("]")) fail({at_, at_}, "expected ']' after the number of steps");
      if (*token.bound < token.from) fail({begin, at_}, "the first number of steps is the smaller one");
    }
  } else {
    at_ = end;
  }
}

// An operator was read; what may follow it directly: [!] or [w] after a next, bounds after F, G and U.
Token Lexer::operation(Symbol symbol, std::size_t begin) {
  Token token{.kind = Token::Kind::Operator, .where = {begin, at_}, .symbol = symbol, .bound = {}, .name = {}};
  if (symbol == Symbol::Next) {
    if (take("[w]") || (!take("[!]") && dialect_ == Dialect::Spot)) token.symbol = Symbol::WeakNext;
  } else if (symbol == Symbol::Eventually || symbol == Symbol::Always || symbol == Symbol::Until) {
    bounds(token);
  }
  token.where.end = at_;
  return token;
}

Token Lexer::word() {
  const std::size_t begin = at_;
  std::size_t end = at_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  const std::string_view word = text_.substr(begin, end - begin);
  if (is_unary_run(word)) {  // one letter now; the rest is such a word again
    ++at_;
    return operation(*unary_letter(word[0]), begin);
  }
  at_ = end;
  Token token{.kind = Token::Kind::Name, .where = {begin, end}, .bound = {}, .name = std::string(word)};
  if (const auto symbol = operator_word(word, notation_, dialect_)) {
    if (*symbol == Symbol::Until) return operation(*symbol, begin);
    token.kind = Token::Kind::Operator;
    token.symbol = *symbol;
  } else if (const auto value = constant_word(word, notation_)) {
    token.kind = Token::Kind::Constant;
    token.value = *value;
  }
  return token;
}

Token Lexer::quoted() {
  const std::size_t begin = at_++;
  std::string name;
  while (at_ < text_.size() && text_[at_] != '"') {
    if (text_[at_] == '\\') {
      if (++at_ == text_.size()) break;
      if (text_[at_] != '"' && text_[at_] != '\\' && text_[at_] != 'n')
        fail({at_ - 1, character_end(text_, at_)}, "expected \\\", \\\\ or \\n in a quoted name");
      name += text_[at_] == 'n' ? '\n' : text_[at_];
    } else {
      name += text_[at_];
    }
    ++at_;
  }
  if (at_ == text_.size()) fail({begin, begin + 1}, "expected a closing '\"' for this one");
  ++at_;
  if (name.empty()) fail({begin, at_}, "expected a name between the quotes");
  return {.kind = Token::Kind::Name, .where = {begin, at_}, .bound = {}, .name = std::move(name)};
}

void Lexer::fail_on_character() const {
  const Span where{at_, character_end(text_, at_)};
  const std::string shown(text_.substr(at_, where.end - at_));
  if (is_digit(text_[at_])) fail(where, "expected a formula; numbers other than 0 and 1 must follow F<=, G<= or U<=");
  if (text_[at_] == '[')
    fail(where, "'[' starts no part of a formula; bounds stand right behind F, G or U: F[0:3], G<=3, U[1:3], F[2:]");
  fail(where, "'" + shown + "' starts no part of a formula (names with such characters go in double quotes)");
}

Token Lexer::next() {
  skip_space();
  const std::size_t begin = at_;
  if (at_ == text_.size()) return {.where = {begin, begin}, .bound = {}, .name = {}};
  const char c = text_[at_];
  if (is_letter(c)) return word();
  if (c == '"') return quoted();
  for (const Spelling& spelling : spellings)
    if (take(spelling.text)) return operation(spelling.symbol, begin);
  if (take("(")) return {.kind = Token::Kind::Open, .where = {begin, at_}, .bound = {}, .name = {}};
  if (take(")")) return {.kind = Token::Kind::Close, .where = {begin, at_}, .bound = {}, .name = {}};
  const bool single = at_ + 1 == text_.size() || !is_digit(text_[at_ + 1]);
  const bool one = (c == '1' && single) || text_.substr(at_, 3) == "⊤";
  if (one || (c == '0' && single) || text_.substr(at_, 3) == "⊥") {
    at_ += is_digit(c) ? 1 : 3;
    return {.kind = Token::Kind::Constant, .where = {begin, at_}, .bound = {}, .value = one, .name = {}};
  }
  fail_on_character();
}

}  // namespace waymark::ltl
