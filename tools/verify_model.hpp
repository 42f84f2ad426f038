// What an answer of `plan --model` or `plan --case` claims, examined on the model: walks step by step, formulas by the
// definition of ⊨, values by progression. No automaton and no solver is used.
#pragma once
#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "tools/claims.hpp"

namespace waymark::tools {

// `limits` bounds the pairs of a state and what remains of the formula. Throws ltl::FormatError for an answer that is
// none, ltl::SyntaxError for its formula.
void examine_on_model(Claims& claims, const plan::JsonReader& in, const Claims::Value& answer,
                      const plan::PlanningCase& model, const ltl::Limits& limits);

}  // namespace waymark::tools
