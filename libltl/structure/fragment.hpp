// The fragments of LTL that contain a formula, by its syntax. "Yes" is proved; "no" means: not visible in the syntax.
//
// Over infinite words these are the classes of the Manna–Pnueli hierarchy ([MP90], [CMP92]):
//   safety ¬bad prefix   co-safety (guarantee) a good prefix   obligation: Boolean combinations of the two
//   recurrence (G F)     persistence (F G)
// Finite words have no such hierarchy. Safety (all prefixes of a word with φ satisfy φ) and co-safety (all extensions
// do) remain; there X belongs to co-safety only and N to safety only.
#pragma once
#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"

namespace waymark::ltl {

struct Fragments {
  bool propositional = false;  // no temporal operator
  bool next_free = false;      // no X, no N: stuttering does not matter
  bool safety = false;         // a violation shows in a finite prefix
  bool cosafety = false;       // satisfaction shows in a finite prefix
  bool obligation = false;     // this and the next two: infinite words only, false under Semantics::Finite
  bool recurrence = false;     // a deterministic Büchi automaton exists
  bool persistence = false;    // the dual of recurrence
  friend bool operator==(const Fragments&, const Fragments&) = default;
};

Fragments fragments(Formula f, Semantics semantics);  // O(DAG)

}  // namespace waymark::ltl
