// Formula → English. read_english (read_english.hpp) is the inverse.
//
//   F (chair & F sofa) & G !blue   →   go to the chair, then go to the sofa; never step on the blue floor.
//   G (p -> X (q U r))             →   whenever p holds, one step later q holds until r holds.
// Clauses with ';' between them all hold. "Eventually", "always" and "whenever" include the present. A part that fits no
// clause has a letter: "(A) holds until p holds. (A) means: eventually q holds."
#pragma once
#include <string>

#include "libltl/english/description.hpp"
#include "libltl/formula.hpp"

namespace waymark::ltl {

// The text has the language of f under the semantics of the options. F φ ∨ F ψ is read as F (φ ∨ ψ).
std::string verbalise(Formula f, const VerbaliseOptions& options = {});

}  // namespace waymark::ltl
