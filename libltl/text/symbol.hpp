// The symbols of the concrete syntax, their arity and precedence.
//
// There are more symbols than stored operators (formula.hpp): the constructors replace F, G, W, M, O, H, Z, T, -> and ^
// by their definitions, and the printer recognises these. Grammar in full: docs/formats/formulas.md.
#pragma once
#include <cstdint>

namespace waymark::ltl {

enum class Symbol : std::uint8_t {
  Not,
  Next,
  WeakNext,
  Eventually,
  Always,
  Yesterday,
  WeakYesterday,
  Once,
  Historically,  // unary
  And,
  Or,
  ExclusiveOr,
  Implies,
  Iff,
  Until,
  Release,
  WeakUntil,
  StrongRelease,
  Since,
  Triggered,  // binary
};

enum class Dialect : std::uint8_t {  // how words, precedences and the next operator are read (dialect.hpp)
  Waymark,                           // X is the strong next, N (WX, X[w]) the weak one; Y Z O H S T speak of the past
  Spot,   // X is the weak next over finite words (TLSF, Syft, Lydia, Spot); X[!] the strong one; no past; GFa is G F a
  Nusmv,  // TRUE, FALSE, V for R, conditions such as state = idle
  Psl,    // always, never, eventually!, next, until!, and, or, not; always binds loosest
};
enum class Notation : std::uint8_t { Infix, Lbt, Postfix };  // where operators stand

constexpr bool is_unary(Symbol s) { return s <= Symbol::Historically; }  // with one operand

// Binds tighter when larger: <-> 1, -> 2, ^ 3, | 4, & 5, U R W M S T 6, unary 7.
constexpr int precedence(Symbol s) {
  switch (s) {
    case Symbol::Iff: return 1;
    case Symbol::Implies: return 2;
    case Symbol::ExclusiveOr: return 3;
    case Symbol::Or: return 4;
    case Symbol::And: return 5;
    case Symbol::Until:
    case Symbol::Release:
    case Symbol::WeakUntil:
    case Symbol::StrongRelease:
    case Symbol::Since:
    case Symbol::Triggered: return 6;
    case Symbol::Not:
    case Symbol::Next:
    case Symbol::WeakNext:
    case Symbol::Eventually:
    case Symbol::Always:
    case Symbol::Yesterday:
    case Symbol::WeakYesterday:
    case Symbol::Once:
    case Symbol::Historically: return 7;
  }
  return 0;  // unreachable: -Werror=switch
}

// φ ∘ ψ ∘ χ reads φ ∘ (ψ ∘ χ). The others group to the left; they are associative in meaning.
constexpr bool is_right_associative(Symbol s) { return s == Symbol::Implies || precedence(s) == 6; }

}  // namespace waymark::ltl
