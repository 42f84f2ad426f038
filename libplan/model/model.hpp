// The concept of a model: a Markov decision process with letters on moves, however the process is stored.
//
// States are numbered from 0. In a state one of its choices is made, one of the outcomes of the choice is drawn, and
// the letter of the outcome is appended to the word; the first letter is that of the start (docs/conventions.md 1).
// Mdp stores all of it, GridWorld and MapMdp compute it when asked. Products, solvers and learners take any Model.
#pragma once
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "libplan/world/letters.hpp"

namespace waymark::plan {

struct ModelOutcome {        // one way that a choice may go
  std::uint32_t target = 0;  // the next state
  LetterId letter;           // that is appended
  double probability = 1;    // of this outcome
};

struct OutcomeVisitor {  // any callable that takes these
  void operator()(std::uint32_t target, LetterId letter, double probability) const;
};
struct StateVisitor {  // stands for any function of a state
  void operator()(std::uint32_t state) const;
};

template <class M>
concept Model = requires(const M& model, std::uint32_t s, std::uint32_t k, std::uint32_t i) {
  { model.states() } -> std::same_as<std::size_t>;
  { model.initial() } -> std::same_as<std::uint32_t>;
  { model.initial_letter() } -> std::same_as<LetterId>;
  { model.letters() } -> std::same_as<const Letters&>;
  { model.is_deterministic() } -> std::same_as<bool>;  // one outcome for every choice
  // Choices of a state: how many, and of the k-th its name and cost.
  { model.choices(s) } -> std::same_as<std::uint32_t>;
  { model.action(s, k) } -> std::same_as<std::string_view>;
  { model.cost(s, k) } -> std::same_as<double>;
  // Outcomes of a choice: how many, each by its number, or all of them in that order.
  { model.outcome_count(s, k) } -> std::same_as<std::uint32_t>;
  { model.outcome(s, k, i) } -> std::convertible_to<ModelOutcome>;
  model.for_each_outcome(s, k, OutcomeVisitor{});
  model.for_each_predecessor(s, StateVisitor{});  // the states with an outcome into s, each once
  { model.name(s) } -> std::same_as<std::string>;
};

struct TargetVisitor {  // any callable that takes these
  void operator()(std::uint32_t target, LetterId letter, std::uint32_t times) const;
};

// A model whose choices share their targets, so that graph searches need not look at every choice.
template <class M>
concept TargetModel = Model<M> && requires(const M& model, std::uint32_t s) {
  model.for_each_target(s, TargetVisitor{});      // each once, and how many outcomes of all choices lead there
  { model.letter(s) } -> std::same_as<LetterId>;  // of every outcome into s
};

}  // namespace waymark::plan
