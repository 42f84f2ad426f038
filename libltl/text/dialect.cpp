#include "libltl/text/dialect.hpp"

#include <algorithm>
#include <array>

#include "libltl/text/character.hpp"

namespace waymark::ltl {
namespace {

struct Word {
  std::string_view text;
  Symbol symbol;
};

constexpr std::array<Word, 12> psl_words{{
    {"always", Symbol::Always},
    {"eventually!", Symbol::Eventually},
    {"next", Symbol::WeakNext},
    {"next!", Symbol::Next},
    {"X", Symbol::WeakNext},
    {"X!", Symbol::Next},
    {"until", Symbol::WeakUntil},
    {"until!", Symbol::Until},
    {"and", Symbol::And},
    {"or", Symbol::Or},
    {"not", Symbol::Not},
    {"xnor", Symbol::Iff},
}};

struct Elsewhere {
  std::string_view word, meant;
};

// In lower case.
constexpr std::array<Elsewhere, 21> elsewhere{{
    {"and", "'&'"},      {"or", "'|'"},         {"not", "'!'"},    {"implies", "'->'"},  {"iff", "'<->'"},
    {"xnor", "'<->'"},   {"next", "'X'"},       {"always", "'G'"}, {"globally", "'G'"},  {"never", "'G !'"},
    {"finally", "'F'"},  {"eventually", "'F'"}, {"until", "'U'"},  {"release", "'R'"},   {"releases", "'R'"},
    {"since", "'S'"},    {"triggered", "'T'"},  {"once", "'O'"},   {"yesterday", "'Y'"}, {"historically", "'H'"},
    {"weaknext", "'N'"},
}};

std::string lower(std::string_view word) {
  std::string out(word);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
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

std::optional<Symbol> operator_letter(char c, Dialect dialect) {
  if (dialect == Dialect::Waymark || dialect == Dialect::Nusmv)
    if (const auto past = past_letter(c)) return past;
  if (dialect == Dialect::Nusmv && c != 'U' && c != 'V') return std::nullopt;
  return binary_letter(c);
}

Binding of_spot(Symbol symbol) {  // -> and <-> on one level, ^ above |
  switch (precedence(symbol)) {
    case 1:
    case 2: return {2, true};
    case 3: return {4, false};
    case 4: return {3, false};
    default: return {precedence(symbol), is_right_associative(symbol)};
  }
}

Binding of_nusmv(Symbol symbol) {  // -> loosest, ^ with |, temporal operators to the left
  switch (precedence(symbol)) {
    case 1: return {2, false};
    case 2: return {1, true};
    case 3: return {4, false};
    default: return {precedence(symbol), false};
  }
}

Binding of_psl(Symbol symbol) {  // Boolean operators are those of the hardware language, and bind tightest
  switch (symbol) {
    case Symbol::Always: return {1, false};
    case Symbol::Implies:
    case Symbol::Iff: return {2, true};
    case Symbol::Next:
    case Symbol::WeakNext:
    case Symbol::Eventually: return {4, false};
    case Symbol::Or: return {5, false};
    case Symbol::ExclusiveOr: return {6, false};
    case Symbol::And: return {7, false};
    case Symbol::Not: return {8, false};
    case Symbol::Until:
    case Symbol::Release:
    case Symbol::WeakUntil:
    case Symbol::StrongRelease:
    case Symbol::Since:
    case Symbol::Triggered: return {3, true};
    case Symbol::Yesterday:
    case Symbol::WeakYesterday:
    case Symbol::Once:
    case Symbol::Historically: break;
  }
  return {4, false};
}

}  // namespace

Binding binding(Symbol symbol, Dialect dialect) {
  switch (dialect) {
    case Dialect::Waymark: return {precedence(symbol), is_right_associative(symbol)};
    case Dialect::Spot: return of_spot(symbol);
    case Dialect::Nusmv: return of_nusmv(symbol);
    case Dialect::Psl: return of_psl(symbol);
  }
  return {};  // unreachable: -Werror=switch
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

bool is_unary_run(std::string_view word, Dialect dialect) {
  return std::all_of(word.begin(), word.end(),
                     [&](char c) { return unary_letter(c).has_value() && (c != 'N' || dialect == Dialect::Waymark); });
}

std::optional<Symbol> operator_word(std::string_view word, Notation notation, Dialect dialect) {
  if (word == "xor") return Symbol::ExclusiveOr;
  if (word == "WX" && dialect == Dialect::Waymark) return Symbol::WeakNext;
  if (word == "xnor" && dialect == Dialect::Nusmv) return Symbol::Iff;
  if (dialect == Dialect::Psl)
    for (const Word& known : psl_words)
      if (known.text == word) return known.symbol;
  if (word.size() != 1) return std::nullopt;
  if (notation == Notation::Lbt && word == "i") return Symbol::Implies;
  if (notation == Notation::Lbt && word == "e") return Symbol::Iff;
  return operator_letter(word[0], dialect);
}

std::optional<bool> constant_word(std::string_view word, Notation notation, Dialect dialect) {
  if (word == "true" || word == "tt" || (notation == Notation::Lbt && word == "t")) return true;
  if (word == "false" || word == "ff" || (notation == Notation::Lbt && word == "f")) return false;
  if (dialect == Dialect::Waymark) return std::nullopt;
  const std::string small = lower(word);
  if (small != "true" && small != "false") return std::nullopt;
  return small == "true";
}

std::optional<Symbol> leading_operator(std::string_view word, bool behind_operand) {
  const bool before_digit = word.size() > 1 && is_digit(word[1]);
  if (word[0] != 'N' && !before_digit)
    if (const auto unary = unary_letter(word[0])) return unary;
  return behind_operand ? binary_letter(word[0]) : std::nullopt;
}

std::string_view meant_by(std::string_view word, Dialect dialect) {
  if (word == "last") return dialect == Dialect::Spot ? "'!X[!] true', the last letter" : "'!X true', the last letter";
  if (word == "end") return "'!X true', the last letter";
  const std::string small = lower(word);
  if (word != small && small == "true") return "'true'";
  if (word != small && small == "false") return "'false'";
  for (const Elsewhere& row : elsewhere)
    if (row.word == small) return dialect == Dialect::Psl && small == "eventually" ? "'eventually!'" : row.meant;
  return "";
}

bool is_branching(std::string_view word) {
  if (word.empty() || word.size() > 2 || (word[0] != 'A' && word[0] != 'E')) return false;
  return word.size() == 1 || word[1] == 'X' || word[1] == 'F' || word[1] == 'G' || word[1] == 'U';
}

std::string_view unsupported(std::string_view word, Dialect dialect) {
  if (dialect == Dialect::Nusmv && word == "next") return "next(…) of NuSMV is not read in formulas; X is";
  if (dialect != Dialect::Psl) return "";
  if (word.starts_with("until_")) return "the overlapping until_ of PSL is not read; until and until! are";
  if (word.starts_with("before")) return "before of PSL is not read; !b U a is, and !b W a";
  if (word.starts_with("next_")) return "next_a, next_e and next_event of PSL are not read; next[3] and next![3] are";
  return word == "abort" || word == "async_abort" || word == "sync_abort" ? "abort of PSL is not read" : "";
}

std::string spelled_apart(std::string_view name) {
  std::string out;
  std::size_t letters = 0;
  for (; letters < name.size() && name[letters] != 'N' && unary_letter(name[letters]); ++letters)
    out += {name[letters], ' '};
  const std::string_view rest = name.substr(letters);
  if (letters == 0 || rest.empty() || rest[0] < 'a' || rest[0] > 'z') return "";
  if (letters == 1 && !std::all_of(rest.begin() + 1, rest.end(), is_digit)) return "";  // Goal, Front
  return out + std::string(rest);
}

}  // namespace waymark::ltl
