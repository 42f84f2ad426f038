// The product as an explicit Markov decision process, for those who want to look at it or check it elsewhere.
//
// Letters say what matters for acceptance: `goal` where a goal of a finite task was entered, `marked` where the edge was
// marked. Hence Pmax of the task is Pmax of F goal, or of G F marked; its least cost is that of F goal.
#pragma once
#include "libplan/model/prism/state_labels.hpp"
#include "libplan/product/product_mdp.hpp"

namespace waymark::plan {

// A pair (place, task) is called by its place (x and y of a grid) and the state of the automaton; −1 all of them is
// `lost`, from where the task cannot be met. Goals and `lost` stay where they are, at no cost. When a run may begin in several states (an automaton that may guess
// at once), a state of its own, −2, chooses among them at no cost. A state of the model without choices stays, too.
StateLabelled explicit_product(const ProductMdp<Mdp>& product);
StateLabelled explicit_product(const ProductMdp<GridWorld>& product);

}  // namespace waymark::plan
