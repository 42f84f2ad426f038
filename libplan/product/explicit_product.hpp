// The product as an explicit Markov decision process, for inspection and for other tools.
//
// Letters tell acceptance: `goal` where a goal of a finite task was entered, `marked` where the edge was marked. Hence
// Pmax of the task is Pmax of F goal, or of G F marked; the least cost of the task is that of F goal.
#pragma once
#include "libplan/model/prism/state_labels.hpp"
#include "libplan/product/product_mdp.hpp"

namespace waymark::plan {

// The name of a pair (place, task) is its place (x and y on a grid) and the state of the automaton. The state `lost`,
// −1 in all variables, stands for pairs from which the task cannot be satisfied. Goals and `lost` are absorbing, at no
// cost, and so are states of the model without choices. Where a run may begin in several states, an extra state, −2,
// chooses among them at no cost.
StateLabelled explicit_product(const ProductMdp<Mdp>& product);
StateLabelled explicit_product(const ProductMdp<GridWorld>& product);

}  // namespace waymark::plan
