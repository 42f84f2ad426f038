// Models for PRISM [KNP11]: explicit files and the language, so that others can check our values
// (docs/formats/prism.md).
//
// Propositions become labels, costs become rewards named "cost". Names that PRISM cannot read are changed: what is no
// letter or digit becomes an underscore, reserved words get one at the end, the second of two equal names a number.
#pragma once
#include <string>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/prism/state_labels.hpp"

namespace waymark::plan {

struct PrismExplicit {            // the contents of the files
  std::string transitions;        // .tra
  std::string states;             // .sta
  std::string labels;             // .lab; those of PRISM first: 0="init" 1="deadlock"
  std::string rewards;            // .srew when all choices of a state cost the same, else .trew
  bool rewards_on_states = true;  // .srew or .trew
};
PrismExplicit write_prism_explicit(const StateLabelled& model);  // as PRISM exports them

// One module over the variables of the model, one command for each choice.
std::string write_prism(const StateLabelled& model);
// Four commands, whatever the size of the grid: where moves are barred and where labels hold are formulas over x and y.
std::string write_prism(const GridWorld& grid);

}  // namespace waymark::plan
