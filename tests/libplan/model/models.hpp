// Random small models, and what tells two models apart.
#pragma once
#include <random>
#include <string>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan::test {

// A few states over the propositions a and b; letters on moves, costs that differ, now and then a state without
// choices.
Mdp random_mdp(std::mt19937& random);
// At most 5 × 5 cells with walls, one-way cells, propositions a and b, and moves that slip.
GridWorld random_grid(std::mt19937& random);

// "" when both have the same states, choices, costs, outcomes and letters in the same order; else the first difference.
// Names of states and actions are not compared.
std::string difference(const Mdp& a, const Mdp& b);

}  // namespace waymark::plan::test
