// Turns that a program leaves open, made at once.
#pragma once
#include "libltl/formula.hpp"

namespace waymark::parser {

// `turn left` of a program is X(turned U (turned ∧ turned_left ∧ rest)) and allows other turns before; `turned` is
// turned_left ∨ turned_right. A person who says it means X(turned_left ∧ rest), which is stronger. O(DAG)
ltl::Formula with_direct_turns(ltl::Formula f);

}  // namespace waymark::parser
