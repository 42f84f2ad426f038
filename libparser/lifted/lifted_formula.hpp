// What a lifted formula denotes, and how a formula is spelled.
//
//   visit a b            F a & F b                          patrol a b       G F a & G F b
//   never a b            G !a & G !b                        sequence a b c   F(a & F(b & F c))
//   ordered a b c        (!b U a) & (!c U b) & F c          strict a b       ordered a b & (!a U (a U (!a U b)))
//   atleast 2 a          F(a & (a U (!a & (!a U F a))))     visits are stays: a visit may last
//   atmost 1 a           !atleast 2 a                       exactly 1 a      a M (!a | G(a | G !a))
//   react a b            G(a -> F b)                        follow a b       G(a <-> X b)
//   after a b            G(a -> X G !b)                     alternate a b    G F a & G F b, and in turn: see the source
//   stayon a             G(moved -> behind_a)               ifelse c a b     (c & a) | (!c & b)
//   sequence … steps 2   X(moved & X moved)                 sequence … turnleft    X turned_left
// Counts of events (turned_left …) count moments: atmost 1 turned_left is !F(turned_left & X F turned_left).
#pragma once
#include <functional>
#include <optional>

#include "libltl/formula.hpp"
#include "libparser/lifted/lifted_symbol.hpp"

namespace waymark::parser {

// The propositions behind a lifted formula. `literal` is asked for a thing by itself (direction End) or with a
// direction, and for events. None: nothing of the kind exists, and the formula has no meaning here.
struct Bindings {
  ltl::Arena* arena = nullptr;  // of the formulas
  // Nothing: the map has no such literal.
  std::function<std::optional<ltl::Formula>(LiftedSymbol direction, LiftedSymbol thing)> literal;
};

// None when a literal does not exist. Throws std::invalid_argument when it is no complete lifted formula.
std::optional<ltl::Formula> formula_of(std::span<const LiftedSymbol> lifted, const Bindings& bindings);

// A literal of a proposition: a thing or an event by itself, or a direction and a thing.
using SpelledLiteral = std::function<std::optional<Lifted>(ltl::Proposition)>;
// A spelling of φ whose formula is φ: macros where φ is one, operators elsewhere. None where a proposition has no
// literal or the past is spoken of. Finds counts up to five, orders of up to five places, and actions that follow one
// another. [LYIL23]
std::optional<Lifted> spell(ltl::Formula f, const SpelledLiteral& literal);

}  // namespace waymark::parser
