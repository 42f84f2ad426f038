// Substitution of formulas for propositions. Renaming into another arena (transfer, formula.hpp) is a special case.
#pragma once
#include <functional>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// f with image(p) in the place of every proposition p; the images live in `to`. O(DAG).
Formula substitute(Formula f, Arena& to, const std::function<Formula(Proposition)>& image);

}  // namespace waymark::ltl
