// The exact value of a policy: the Markov chain that the policy leaves of the product, solved as linear systems.
//
//   probability   of acceptance                          x = P x + (P to accepting states)
//   cost          expected until acceptance, given it     y = P y + c ∘ x,  cost = y / x
//   value         E γ^(T−1), T the actions to acceptance  v = γ P v + (P to accepting states): what the learners
//     maximise
// over the states from which acceptance is reachable, where the matrices are regular; all means over the starts.
// Source: [BK08, Sec. 10.1.1]. Chains in which every state has one successor are walked instead.
#pragma once
#include <cstdint>
#include <vector>

#include "libplan/learn/tabular_product.hpp"

namespace waymark::plan {

struct PolicyChain {           // a policy in a product
  struct Outcome {             // of the action that the policy takes
    std::uint32_t target = 0;  // a state
    double probability = 1;    // of this outcome
  };
  std::vector<std::uint32_t> first{0};       // by state: where its outcomes begin; one more for the end
  std::vector<Outcome> outcomes;             // none: the state is left no more
  std::vector<double> cost;                  // of the step out of a state
  std::vector<Ending> ending;                // by state
  std::vector<PolicyChain::Outcome> starts;  // where episodes begin

  std::size_t states() const { return ending.size(); }  // of the product
};

struct PolicyValue {
  double probability = 0;  // of acceptance
  double cost = 0;         // infinite when the probability is 0
  double value = 0;        // discounted, reward 1 on acceptance
};

PolicyValue value_of(const PolicyChain& chain, double discount);  // of all starts together

inline constexpr std::uint8_t no_action = UINT8_MAX;  // where a task is over
using ActionTable = std::vector<std::uint8_t>;        // by state of a TabularProduct

// The part of the product that the policy reaches.
PolicyChain chain_of(const TabularProduct& product, const ActionTable& policy);
inline PolicyValue value_of(const TabularProduct& product, const ActionTable& policy, double discount) {
  return value_of(chain_of(product, policy), discount);
}

}  // namespace waymark::plan
