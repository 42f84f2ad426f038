// Random programs of two modules, written in the language of PRISM and in JANI, with the same properties in both.
#pragma once
#include <random>
#include <string>

namespace waymark::testing {

struct TwoLanguages {
  std::string prism, properties;  // a model, and a file of properties
  std::string jani;               // both in one document
};

// mdp or dtmc: four variables, commands that synchronise or do not, a label "goal", rewards "r" of states and actions.
// Costs are whole and probabilities eighths, so that both readers compute the same numbers. In JANI some assignments
// come in a later round than others. The constant k is to be 0, 1 or 2.
TwoLanguages random_program(std::mt19937& random);

}  // namespace waymark::testing
