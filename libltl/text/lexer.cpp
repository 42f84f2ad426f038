#include "libltl/text/lexer.hpp"

#include <algorithm>
#include <utility>

#include "libltl/printable_name.hpp"
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

// Where the character that begins at the offset ends; a byte that is no UTF-8 is one.
std::size_t character_end(std::string_view text, std::size_t at) {
  return at + std::max<std::size_t>(1, utf8_character(text, at));
}

}  // namespace

bool is_bare_name(std::string_view name, Notation notation) {
  return is_identifier(name) && !is_unary_run(name, Dialect::Waymark) &&
         !operator_word(name, notation, Dialect::Waymark) && !constant_word(name, notation, Dialect::Waymark) &&
         meant_by(name, Dialect::Waymark).empty();
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

// X[3] and X[3!]: so many nexts, strong with !.
void Lexer::repetition(Token& token) {
  if (at_ + 1 >= text_.size() || text_[at_] != '[' || !is_digit(text_[at_ + 1])) return;
  const std::size_t begin = at_++;
  const std::size_t k = steps();
  if (take("!")) token.symbol = Symbol::Next;
  if (!take("]")) fail({at_, at_}, "expected ']' after the number of steps");
  if (k == 0) fail({begin, at_}, "expected one step or more");
  token.from = k - 1;
}

// An operator was read; what may follow it directly: [!] or [w] after a next, bounds after F, G and U.
Token Lexer::operation(Symbol symbol, std::size_t begin) {
  Token token{.kind = Token::Kind::Operator, .where = {begin, at_}, .symbol = symbol, .bound = {}, .name = {}};
  if (symbol == Symbol::Next) {
    if (take("[w]") || (!take("[!]") && dialect_ == Dialect::Spot)) token.symbol = Symbol::WeakNext;
  } else if (symbol == Symbol::Eventually || symbol == Symbol::Always || symbol == Symbol::Until) {
    bounds(token);
  }
  if (symbol == Symbol::Next || symbol == Symbol::WeakNext) repetition(token);
  token.where.end = at_;
  token.binding = binding(token.symbol, dialect_);
  return token;
}

std::size_t Lexer::word_end(std::size_t at) const {
  const auto continues = [&](char c) {
    if (is_letter(c) || is_digit(c)) return true;
    if (dialect_ == Dialect::Nusmv) return c == '.' || c == '$' || c == '#';
    return dialect_ == Dialect::Spot && c == '.';
  };
  while (at < text_.size() && continues(text_[at])) ++at;
  return at;
}

// Of NuSMV: state = idle and count >= 3 are one proposition, of that name.
void Lexer::compare(Token& name) {
  const std::size_t end = at_;
  skip_space();
  const auto stands = [&](std::string_view sign) { return text_.substr(at_, sign.size()) == sign; };
  const bool joins = stands("=>") || stands("<->") || stands("<=>") || stands("<>");  // it is no comparison
  for (const std::string_view sign : {"!=", "<=", ">=", "=", "<", ">"}) {
    if (joins || !take(sign)) continue;
    skip_space();
    const std::size_t begin = at_;
    take("-");
    at_ = word_end(at_);
    if (at_ == begin) fail({at_, at_}, "expected a number or a name to compare with");
    name.name += " " + std::string(sign) + " " + std::string(text_.substr(begin, at_ - begin));
    name.where.end = at_;
    return;
  }
  at_ = end;
}

// always, never, next!, until! and the others; a name where the word is none of them.
Token Lexer::psl_word(std::size_t begin) {
  const std::string_view word = text_.substr(begin, at_ - begin);
  if (word == "never") {
    Token always = operation(Symbol::Always, begin);
    pending_ = {.kind = Token::Kind::Operator, .where = always.where, .symbol = Symbol::Not, .bound = {}, .name = {}};
    pending_->binding = always.binding;
    return always;
  }
  for (const bool strong : {true, false}) {
    if (strong && text_.substr(at_, 1) != "!") continue;
    const auto symbol = operator_word(text_.substr(begin, at_ + (strong ? 1 : 0) - begin), notation_, dialect_);
    if (!symbol) continue;
    at_ += strong ? 1 : 0;
    return operation(*symbol, begin);
  }
  return {.kind = Token::Kind::Name, .where = {begin, at_}, .bound = {}, .name = std::string(word)};
}

Token Lexer::word() {
  const std::size_t begin = at_, end = word_end(at_);
  const std::string_view word = text_.substr(begin, end - begin);
  if (const auto message = unsupported(word, dialect_); !message.empty()) fail({begin, end}, message);
  Token token{.kind = Token::Kind::Name, .where = {begin, end}, .bound = {}, .name = std::string(word)};
  if (const auto value = constant_word(word, notation_, dialect_)) {
    at_ = end;
    token.kind = Token::Kind::Constant;
    token.value = *value;
    return token;
  }
  const bool run = is_unary_run(word, dialect_) && dialect_ != Dialect::Psl;
  const auto first = dialect_ == Dialect::Spot && notation_ == Notation::Infix ? leading_operator(word, behind_operand_)
                     : run                                                     ? unary_letter(word[0])
                                                                               : std::nullopt;
  if (first) {  // one letter now; the rest is a word again
    ++at_;
    return operation(*first, begin);
  }
  at_ = end;
  if (dialect_ == Dialect::Psl) {
    if (word.size() == 1)
      if (const auto unary = unary_letter(word[0]); unary && *unary != Symbol::Next && *unary != Symbol::WeakNext)
        return operation(*unary, begin);
    return psl_word(begin);
  }
  if (const auto symbol = operator_word(word, notation_, dialect_)) return operation(*symbol, begin);
  if (dialect_ == Dialect::Nusmv) compare(token);
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
  if (!is_printable_name(name)) fail({begin, at_}, "a name has no control characters, and is UTF-8");
  return {.kind = Token::Kind::Name, .where = {begin, at_}, .bound = {}, .quoted = true, .name = std::move(name)};
}

void Lexer::fail_on_character() const {
  const Span where{at_, character_end(text_, at_)};
  const std::string shown(text_.substr(at_, where.end - at_));
  if (is_digit(text_[at_])) fail(where, "expected a formula; numbers other than 0 and 1 must follow F<=, G<= or U<=");
  if (text_[at_] == '[' && at_ > 0 && (text_[at_ - 1] == 'A' || text_[at_ - 1] == 'E'))
    fail({at_ - 1, at_},
         "A[…] and E[…] are operators of CTL, which is not read; a formula of LTL speaks of every path");
  if (text_[at_] == '[')
    fail(where, "'[' starts no part of a formula; bounds stand right behind F, G or U: F[0:3], G<=3, U[1:3], F[2:]");
  const auto stands = [&](std::string_view sign) { return text_.substr(at_, sign.size()) == sign; };
  if (stands("-->") || stands("|->") || stands("<-->") || stands("<==>") || stands("==>"))
    fail({at_, text_.find('>', at_) + 1}, stands("<")   ? "no operator is written like this (did you mean '<->'?)"
                                          : stands("|") ? "sequences of PSL are not read"
                                                        : "no operator is written like this (did you mean '->'?)");
  if (shown == "{" && dialect_ != Dialect::Waymark) fail(where, "sequences of PSL (SERE) are not read");
  fail(where, "'" + shown + "' starts no part of a formula (names with such characters go in double quotes)");
}

// LTLSPEC and assert in front of a formula that was copied from a file, and the semicolon behind it.
void Lexer::pass_over_frame() {
  const std::size_t begin = at_;
  const std::string_view word = text_.substr(at_, word_end(at_) - at_);
  if ((dialect_ == Dialect::Nusmv && word == "LTLSPEC") || (dialect_ == Dialect::Psl && word == "assert"))
    at_ = begin + word.size();
  skip_space();
}

Token Lexer::next() {
  if (pending_) return *std::exchange(pending_, std::nullopt);
  skip_space();
  if (dialect_ == Dialect::Nusmv || dialect_ == Dialect::Psl) {
    if (text_.find_first_not_of(" \t\r\n") == at_) pass_over_frame();
    if (at_ < text_.size() && text_[at_] == ';' && text_.find_first_not_of(" \t\r\n;", at_) == std::string_view::npos)
      at_ = text_.size();
  }
  Token token = scan();
  behind_operand_ = token.kind == Token::Kind::Name || token.kind == Token::Kind::Close;
  return token;
}

Token Lexer::scan() {
  const std::size_t begin = at_;
  if (at_ == text_.size()) return {.where = {begin, begin}, .bound = {}, .name = {}};
  const char c = text_[at_];
  if (is_letter(c)) return word();
  if (c == '"') return quoted();
  for (const std::string_view sign : {"-->", "<-->"})  // as in GOAL
    if (dialect_ == Dialect::Spot && take(sign))
      return operation(sign[0] == '-' ? Symbol::Implies : Symbol::Iff, begin);
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
