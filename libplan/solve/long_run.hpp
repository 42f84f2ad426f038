// What a Markov chain does in the long run: from every state, the mean of a value over the steps of a run without end.
//
// A run ends in a bottom strongly connected component, whose stationary distribution weighs the values. Where it ends
// is a linear system over the other states. [BK08, Sec. 10.1.2]
#pragma once
#include <optional>
#include <stop_token>
#include <vector>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// By state; every state has one choice. `values` by state. Exact up to the rounding of sparse LU factorisations.
// nullopt: stopped, or a system that doubles cannot solve. Throws std::invalid_argument where a state has choices.
std::optional<std::vector<double>> long_run(const Mdp& chain, const std::vector<double>& values,
                                            const std::stop_token& stop = {});

}  // namespace waymark::plan
