// Trajectories that somebody judged: ones that a sentence allows, and ones that it does not.
//
// One trajectory satisfies many formulas. A refused trajectory refutes every program whose formula it satisfies, and a
// good one refutes every program whose formula it violates. Learning reads these judgements and no formula.
#pragma once
#include <vector>

#include "libparser/programs/execute.hpp"

namespace waymark::parser {

struct Judged {
  std::vector<plan::Trajectory> good, refused;  // with their starts
  bool empty() const { return good.empty() && refused.empty(); }
};

// Do all good trajectories satisfy the program's formula, and no refused one? The executor's map is theirs.
bool agrees(const Executor& executor, const Program& program, const Judged& judged);

}  // namespace waymark::parser
