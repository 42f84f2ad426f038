// Substitution of formulas for propositions. Renaming into another arena (transfer, formula.hpp) is a special case.
#pragma once
#include <functional>
#include <span>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// The operator of g over other operands, in another arena of the same vocabulary. One operand for each of g's.
Formula with_operands(Formula g, Arena& to, std::span<const Formula> operands);

// f with image(p) in the place of every proposition p; the images live in `to`. O(DAG).
Formula substitute(Formula f, Arena& to, const std::function<Formula(Proposition)>& image);

}  // namespace waymark::ltl
