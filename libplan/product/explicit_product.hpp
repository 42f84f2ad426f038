// The product as an explicit Markov decision process, for those who want to look at it or check it elsewhere.
//
// Letters say what matters for acceptance: `goal` where a goal of a finite task was entered, `marked` where the edge was
// marked. Hence Pmax of the task is Pmax of F goal, or of G F marked; its least cost is that of F goal.
#pragma once
#include <optional>
#include <vector>

#include "libplan/model/state_labels.hpp"
#include "libplan/product/product_mdp.hpp"

namespace waymark::plan {

struct ExplicitProduct {
  Mdp mdp;  // states as the product numbers them, then `lost`, then a start of its own if there must be one
  StateValues
      values;  // the place (x and y of a grid) and the state of the automaton; −1 of lost, −2 of that start
  std::vector<std::uint32_t> starts;
  std::optional<std::uint32_t> lost;  // the task can no longer be met
  std::vector<bool> goals;
};

// Goals and `lost` stay where they are, at no cost. When a run may begin in several states (an automaton that may guess
// at once), the initial state chooses among them at no cost. A state of the model without choices stays, too.
ExplicitProduct explicit_product(const ProductMdp<Mdp>& product);
ExplicitProduct explicit_product(const ProductMdp<GridWorld>& product);

}  // namespace waymark::plan
