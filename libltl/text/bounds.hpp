// Bounded operators, recognised in the formulas that spell them out.
//
// F<=k φ is stored as φ ∨ X(φ ∨ X(… φ)), and G<=k φ as φ ∧ N(φ ∧ N(… φ)), k nexts each. Of one operator and one φ, the
// formulas of all k form a chain: F<=i φ ⇒ F<=j φ and G<=j φ ⇒ G<=i φ for i ≤ j, on finite and infinite words.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::ltl {

struct Bound {                            // F<=steps body, or G<=steps body
  Formula body;                           // the innermost operand
  std::size_t steps;                      // nexts, at least one
  Op junction;                            // Or: F; And: G
  Op next;                                // Next or WeakNext, the same at each level
  bool is_of(const Bound& other) const {  // the same chain
    return body == other.body && junction == other.junction && next == other.next;
  }
  friend bool operator==(const Bound&, const Bound&) = default;
};

class Bounds {  // what is known of the formulas of one arena
 public:
  // Remembered. Recursion as deep as the bound; O(operands²) for each formula that is new.
  std::optional<Bound> of(Formula f);

  struct Part {                          // of a junction
    Bound bound;                         // of `members`, joined
    std::vector<Formula> members, rest;  // sorted
  };
  // Some operands of a junction that are a bounded operator by themselves: of ¬p ∨ φ ∨ X(φ ∨ …), those without ¬p.
  // All of them if they are one, else the longest one. O(operands²).
  std::optional<Part> part(std::span<const Formula> operands, Op junction);

  // φ ⇒ ψ because both are of one chain. O(1) for formulas that are known.
  bool implies(Formula from, Formula to);

 private:
  std::unordered_map<std::uint32_t, std::optional<Bound>> known_;  // by id
};

// Is some subformula a bounded operator of two steps or more? O(DAG), operands² for junctions.
bool has_bounds(Formula f);

}  // namespace waymark::ltl
