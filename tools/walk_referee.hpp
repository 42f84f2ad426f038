// A referee of walks without end, with searches of its own.
//
// Whether there is a walk is asked of the tableau of the formula as it stands: nothing is reduced, and no other
// construction is tried. Costs of lassos belong to the automaton in whose product they are walked (docs/planning.md);
// that automaton is translated anew, and every pair of its product is tried as the place where the cycle begins.
#pragma once
#include <cstdint>
#include <optional>
#include <set>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libltl/word.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/least_lasso.hpp"

namespace waymark::tools {

// Where chance decides, is there a walk if chance were a choice? Where none leads on, it goes on in its place. Nothing,
// here and below: a limit was met, or the formula has past operators.
std::optional<bool> has_walk(const plan::PlanningCase& model, ltl::Formula formula, const ltl::Limits& limits);

struct LassoRank {  // what an order compares, first thing first
  double first = 0, then = 0;
};
// Is this the least rank of all lassos? Of the order mean, a rank that some lasso has.
std::optional<bool> comes_first(const plan::PlanningCase& model, ltl::Formula formula, plan::LassoOrder order,
                                const LassoRank& rank, const ltl::Limits& limits);

// The rounds that accepted runs complete on the cycle of the word, coming back to where they begin it; 0 where a run
// closes without any. Of the order mean alone are there more than one.
std::optional<std::set<std::uint64_t>> rounds_on(const ltl::Lasso& word, ltl::Formula formula,
                                                 const ltl::Limits& limits);

}  // namespace waymark::tools
