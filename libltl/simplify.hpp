// Rewriting under a named semantics. Every rule is a comment (match / result), a function and a table row;
// the law tests check each on all small words.
#pragma once
#include "libltl/formula.hpp"
#include "libltl/semantics.hpp"

namespace waymark::ltl {

Formula simplify(Formula f, Semantics semantics);

}  // namespace waymark::ltl
