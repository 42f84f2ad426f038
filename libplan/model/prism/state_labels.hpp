// Letters moved from moves onto states, as other tools have them: what a model is before it is written for PRISM.
//
// A state that is entered with different letters becomes one state for each of them; the initial one has the letter
// that is read first. Words, probabilities and costs stay what they were [BK08, Def. 10.1]. Reachable part only,
// breadth first.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// What a state is called elsewhere: the values of a few integer variables, different for different states.
struct StateValues {
  std::vector<std::string> variables;  // names
  std::vector<std::int32_t> values;    // state after state, as many as there are variables
};

struct StateLabelled {                // with the labels on states
  Mdp mdp;                            // every outcome carries the letter of its target; 0 is the initial state
  std::vector<LetterId> letter;       // by state
  std::vector<std::uint32_t> origin;  // by state: the state of the model
  StateValues values;
};

// A state without choices gets one of cost 0, "stay", that stays: PRISM knows no ends of runs.
// Variables: x and y of a grid, s of others, and `letter` where states were split.
StateLabelled with_labels_on_states(const GridWorld& model);
StateLabelled with_labels_on_states(const Mdp& model);
// The same with variables of one's own, given for the states of the model.
StateLabelled with_labels_on_states(const Mdp& model, const StateValues& values);

}  // namespace waymark::plan
