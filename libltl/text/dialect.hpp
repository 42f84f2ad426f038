// What distinguishes the dialects of formulas: the words that are operators or constants, and how tightly operators
// bind. Sources: Spot's scanner and grammar; the NuSMV user manual; IEEE 1850 (PSL), its linear part without sequences.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "libltl/text/symbol.hpp"

namespace waymark::ltl {

struct Binding {       // of an operator between or before formulas
  int level = 0;       // binds tighter when larger
  bool right = false;  // φ ∘ ψ ∘ χ reads φ ∘ (ψ ∘ χ)
};
Binding binding(Symbol symbol, Dialect dialect);  // of a binary operator, in that dialect

// Waymark and Infix: is the word a sequence of the unary letters X N F G?
bool is_unary_run(std::string_view word, Dialect dialect);
std::optional<Symbol> unary_letter(char c);  // X N F G
// The operator that the whole word is; for unary letters see above.
std::optional<Symbol> operator_word(std::string_view word, Notation notation, Dialect dialect);
std::optional<bool> constant_word(std::string_view word, Notation notation, Dialect dialect);

// Spot's names do not begin with F, G or X unless a digit follows, nor, behind an operand, with M, U, R, V or W: the
// operator that the first letter of the word is.
std::optional<Symbol> leading_operator(std::string_view word, bool behind_operand);

// A word that is an operator or a constant elsewhere and would be a new name here: how it is written here. "" for other
// words.
std::string_view meant_by(std::string_view word, Dialect dialect);
// The same for words of branching time, in front of a formula: AG, E, …
bool is_branching(std::string_view word);
// Words of PSL that are not read, by what they are; "" for others.
std::string_view unsupported(std::string_view word, Dialect dialect);

// "G F a" of GFa, which is one name in our dialect: for names that look like operators run into a name, else "".
std::string spelled_apart(std::string_view name);

}  // namespace waymark::ltl
