// Formulas → programs: formula_of, backwards.
//
// A formula is peeled: which unit (a step, or a function with its steps) can stand first, and what remains? Formulas of
// one arena are equal when they are the same pointer, so what two branches leave owed can be compared. Where several
// programs have one formula (forward_2 and forward_1 forward_1), one of fewest steps is given.
#pragma once
#include <optional>

#include "libparser/programs/postfix_grammar.hpp"

namespace waymark::parser {

// A program of the grammar whose formula this is; nullopt when none is found. What is found is checked with formula_of.
// Conditions that fold away beside the literals of a step (¬l ∧ l) are not looked for.
std::optional<Program> program_of(ltl::Formula formula, const PostfixGrammar& grammar);

}  // namespace waymark::parser
