// What an answer of `plan --model` or `plan --case` claims, examined on the model: walks step by step, formulas by the
// definition of ⊨, least costs by progression. No automaton and no solver is used.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "tools/shell/input.hpp"

namespace waymark::tools {

struct Claim {
  std::string text;
  std::optional<bool> holds;  // nothing: not decided within the limits
};

// `limits` bounds the pairs of a state and what remains of the formula. Throws ltl::FormatError for an answer that is
// none.
std::vector<Claim> claims_on_model(const Text& answer, const plan::PlanningCase& model, const ltl::Limits& limits);

}  // namespace waymark::tools
