// The labels that properties of every model may name [KNP11]: "init" and "deadlock".
#pragma once
#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

// "init" holds in the initial state; "deadlock" where no command is enabled, and of an action no way to combine the
// commands of all modules that have it. A label that the model defines itself stays. The program must have been read.
void define_labels_of_every_model(const PrismProgram& program, PrismExpressions& expressions);

}  // namespace waymark::plan
