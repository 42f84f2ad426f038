// A view of a formula: the outermost operator of the concrete syntax and its operands.
//
// A view inverts the constructors that replace operators by definitions: true U φ is viewed as F φ, ψ R (φ ∨ ψ) as φ W
// ψ, and so on. A view makes no formula. An operand may be part of a stored junction (the φ of W), hence the type.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/text/symbol.hpp"

namespace waymark::ltl {

struct ViewOperand {           // a formula, or the junction of several
  std::vector<Formula> parts;  // sorted; at least one
  Op junction = Op::And;       // And or Or; says nothing when there is one part
};

struct View {
  Symbol symbol = Symbol::Not;        // the outermost operator
  std::vector<ViewOperand> operands;  // in the order of the text
  std::optional<std::size_t> bound;   // F<=k and G<=k, k ≥ 2
  std::size_t from = 0;               // steps until then: X X F<=3 is F[2:5], of bound 3
};

struct ViewOptions {          // which definitions are recognised
  bool bounds = true;         // recognise F<=k and G<=k
  bool delays = false;        // recognise F[i:j] and G[i:j], bounds behind nexts
  bool implications = false;  // also of φ -> ¬ψ, where the age of the parts shows that it was typed so
};

// f is no atom and no constant. O(operands²) at worst, plus k for bounds.
View view(Formula f, const ViewOptions& options = {});
View view(const ViewOperand& operand, const ViewOptions& options = {});

}  // namespace waymark::ltl
