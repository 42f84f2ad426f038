// The product that learners step in: a model and a task, every pair of position and task a state, in flat arrays.
//
//   state = position · tasks + task          choice = position · actions + action
// Positions are the states of the model. The product is not cut down to what is reachable: counterfactual updates ask
// what an experience would have meant to a task that the learner was not in. An action is offered in a state of the
// model or it is not; one that is not offered (FORWARD into a wall) cannot be taken, and costs nothing.
// The label of the start is read (conventions.md 1): a start is a state after its first letter.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "libplan/learn/task_rows.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct TabularProduct {
  static constexpr std::size_t max_states = std::size_t{1} << 28U;  // more are refused
  struct Outcome {                                                  // of a choice
    std::uint32_t position = 0, letter = 0;                         // the next one, and what is read there
    double up_to = 1;  // the probability of this outcome and of those before it; 1 for the last
  };
  struct Start {              // of an episode
    std::uint32_t state = 0;  // after the first letter
    double probability = 1;   // of beginning here
  };

  TaskRows task;                             // all steps of the task
  std::uint32_t positions = 0, actions = 0;  // of the model
  std::vector<std::string> names;            // by action, in the order that breaks ties
  std::vector<std::uint32_t> first;  // by choice: where its outcomes begin; equal to the next where it is not offered
  std::vector<Outcome> outcomes;     // by choice, one choice after the other
  std::vector<double> cost;          // by choice
  std::vector<Start> starts;         // in sum 1

  // Numbers of states, positions and tasks.
  std::size_t states() const { return std::size_t{positions} * task.tasks; }
  std::uint32_t position_of(std::uint32_t state) const { return state / task.tasks; }
  std::uint32_t task_of(std::uint32_t state) const { return state % task.tasks; }
  std::uint32_t state(std::uint32_t position, std::uint32_t q) const { return position * task.tasks + q; }
  Ending ending(std::uint32_t state) const { return task.ending[task_of(state)]; }
  bool is_offered(std::uint32_t position, std::uint32_t action) const {  // can the action be taken there?
    const std::size_t choice = std::size_t{position} * actions + action;
    return first[choice] != first[choice + 1];
  }
  std::span<const Outcome> outcomes_of(std::uint32_t position, std::uint32_t action) const {  // in a fixed order
    const std::size_t choice = std::size_t{position} * actions + action;
    return {outcomes.data() + first[choice], outcomes.data() + first[choice + 1]};
  }
  bool is_deterministic() const;  // every choice has one outcome
  bool is_over() const;           // at every start: there is nothing to learn
};

// Throws std::length_error when there are more than max_states pairs, std::invalid_argument on a state of the model
// without choices.
TabularProduct compose(const Mdp& model, TaskRows task);
TabularProduct compose(const GridWorld& model, TaskRows task);
// Throws ltl::FormatError as task_rows.hpp says. `starts`: each one equally likely (the mean over unknown headings,
// conventions.md 8); noise: chances to slip.
TabularProduct tabulate(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                        const MapNoise& noise = {});
inline TabularProduct tabulate(const Map& map, const automata::Dfa& dfa, PoseId start, const MapNoise& noise = {}) {
  return tabulate(map, dfa, {&start, 1}, noise);
}

}  // namespace waymark::plan
