// The answer to a property of PRISM or JANI: in the initial state, and where operators are nested or filtered in every
// state that they need.
//
// Operators inside are answered first, from every state, and become propositions. A state takes a solution of its own
// on the part of the model that it reaches: nested operators on n states take n solutions.
#pragma once
#include <optional>
#include <vector>

#include "libplan/model/formats/prism_properties.hpp"
#include "libplan/model/formats/result_comment.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/pareto.hpp"

namespace waymark::plan {

struct PropertyAnswer {                 // of a property
  CaseAnswer answer;                    // its value; of truth values 1 or 0; of a range where it begins
  std::optional<bool> verdict;          // of what is true or false, where the bounds tell
  std::optional<Bounds> range;          // where a range ends
  std::vector<ParetoPoint> curve = {};  // of several objectives: the vertices, also those of bounded ones
};

// Values of P and R lie between proved bounds; of S, and of rewards of so many steps, they are exact up to rounding.
// Exhausted: a limit was met, or the bounds of an operator inside do not tell whether it holds. Throws
// std::invalid_argument for what has no answer, such as a filter over no state.
PropertyAnswer answer(const PrismProperty& property, const CaseOptions& options);

// Are these the points of a RESULT comment, [(0,1),(0.6,0.4)], in any order? As `agrees` of numbers.
std::optional<bool> agrees(const std::string& result, const std::vector<ParetoPoint>& curve);

}  // namespace waymark::plan
