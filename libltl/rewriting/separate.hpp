// Eventual and universal formulas are moved out of temporal operators. Infinite words only.
//
// φ is eventual when φ holds wherever some suffix satisfies φ (F a), and universal when every suffix of a word with φ
// satisfies φ (G a). A formula with both properties depends on late suffixes only (G F a): such a formula may be read
// now or later, and an automaton that reads the formula late is small. The classes: [EH00, Sec. 4]; the rules after
// [BKRS12, Sec. 3] and [SB00]. A rule may enlarge the formula, unlike simplify().
#pragma once
#include <unordered_map>

#include "libltl/formula.hpp"

namespace waymark::ltl {

struct Purity {                                        // of one formula
  bool eventual = false;                               // v ⊨ φ implies uv ⊨ φ
  bool universal = false;                              // uv ⊨ φ implies v ⊨ φ
  bool both() const { return eventual && universal; }  // depends on the far future only
};
Purity purity(Formula f);  // read off the syntax: "yes" is proved. O(DAG)

class Purities {  // … of many formulas of one arena, remembered: O(DAG) of all together
 public:
  Purity of(Formula f);  // as purity(f)

 private:
  Purity compute(Formula f) const;  // of operands that are known
  std::unordered_map<Formula, Purity> known_;
};

// φ in negation normal form without ↔ in and out, of the same infinite words. Passes over the DAG, at most four.
Formula separate(Formula f);

}  // namespace waymark::ltl
