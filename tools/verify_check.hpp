// What an answer of `check --model` claims: that every run of a model satisfies a formula, or a counterexample.
#pragma once
#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "tools/claims.hpp"

namespace waymark::tools {

// Throws ltl::FormatError for an answer that is none, ltl::SyntaxError for its formula.
void examine_check(Claims& claims, const plan::JsonReader& in, const Claims::Value& answer,
                   const plan::PlanningCase& model, const ltl::Limits& limits);

}  // namespace waymark::tools
