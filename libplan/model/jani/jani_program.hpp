// A JANI document of type mdp or dtmc [BDH+17] as a program of guarded commands, which prism_model explores.
//
// An element of the composition is a module, its location a variable, an edge a command. Synchronisation vectors,
// rounds of assignments (`index`) and transient variables are parts of PrismProgram that PRISM's own language has not.
// Transient truth values become labels, transient numbers become rewards: what locations say of them is earned in a
// state, what edges assign to them on a step.
#pragma once
#include "libplan/model/jani/jani_expression.hpp"
#include "libplan/model/jani/jani_text.hpp"
#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

// Names of the document are known to `names` afterwards. Constants without a value take it from `constants`. Throws
// ltl::FormatError with the place, also for what JANI has and this reader has not.
PrismProgram read_jani_program(const JaniText& text, PrismExpressions& expressions, JaniExpressions& names,
                               const PrismConstants& constants);

// Throws ltl::FormatError for a constant that no declaration took.
void expect_given(const JaniText& text, const PrismConstants& constants, const std::vector<std::string>& given);

}  // namespace waymark::plan
