// Pure eventualities, universal formulas and what is both, pulled out of temporal operators. Infinite words only.
//
// φ is eventual when it holds wherever some suffix satisfies it (F a), universal when every suffix of a word that
// satisfies it does (G a), both when only the far end of a word matters (G F a): then it may be looked at now or later,
// and an automaton that looks at it late is small. The classes: [EH00, Sec. 4]; the rules after [BKRS12, Sec. 3] and
// [SB00]. Unlike simplify(), a rule may make the tree grow.
#pragma once
#include "libltl/formula.hpp"

namespace waymark::ltl {

struct Purity {
  bool eventual = false;   // v ⊨ φ implies uv ⊨ φ
  bool universal = false;  // uv ⊨ φ implies v ⊨ φ
  bool both() const { return eventual && universal; }
};
Purity purity(Formula f);  // read off the syntax: "yes" is proved. O(DAG)

// φ in negation normal form without ↔ in and out, of the same infinite words. Passes over the DAG, at most four.
Formula separate(Formula f);

}  // namespace waymark::ltl
