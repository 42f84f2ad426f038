// The Markov chain that a strategy makes of a product, stored flat, with the public interface of ProductMdp.
// The same solvers evaluate a strategy. Sweeps are faster than on a StrategyChain; the memory is larger.
#pragma once
#include <cstdint>
#include <vector>

#include "libplan/solve/strategy_chain.hpp"

namespace waymark::plan {

class MarkovChain {
 public:
  struct State {          // of the chain
    std::uint32_t index;  // from 0
  };
  using Compact = State;                             // as of ProductMdp
  static constexpr std::uint32_t trap = UINT32_MAX;  // no state

  // The states that the strategy meets from its start; the product has one. Where it makes no choice the chain stays,
  // at no cost.
  template <class Product>
  MarkovChain(const Product& product, const Strategy& strategy) {
    std::vector<std::uint32_t> number(product.states(), trap);
    const auto meet = [&](std::uint32_t i) {
      if (number[i] == trap) {
        number[i] = static_cast<std::uint32_t>(origin_.size());
        origin_.push_back(i);
      }
      return number[i];
    };
    meet(strategy.start);
    for (std::uint32_t i = 0; i < origin_.size(); ++i) {
      const auto s = product.state(origin_[i]);
      const std::uint32_t choice = strategy.choice[s.index];
      first_.push_back(static_cast<std::uint32_t>(outcomes_.size()));
      goal_.push_back(product.is_goal(s));
      cost_.push_back(choice == Strategy::none ? 0 : product.cost(s, choice));
      if (choice == Strategy::none) {
        outcomes_.push_back({i, 1, false});
        continue;
      }
      product.for_each_outcome(s, choice, [&](std::uint32_t t, double p, bool marked) {
        outcomes_.push_back({t == Product::trap ? trap : meet(t), p, marked});
      });
    }
    finish();
  }

  std::uint32_t states() const { return static_cast<std::uint32_t>(origin_.size()); }  // those that the strategy meets
  std::uint32_t origin(std::uint32_t i) const { return origin_[i]; }                   // in the product; 0 is the start
  // What the interface of ProductMdp asks.
  State state(std::uint32_t i) const { return {i}; }
  State state(State s) const { return s; }
  State compact(State s) const { return s; }
  const std::vector<std::uint32_t>& blocks() const { return blocks_; }
  bool is_goal(State s) const { return goal_[s.index]; }
  std::uint32_t choices(State) const { return 1; }
  double cost(State s, std::uint32_t) const { return cost_[s.index]; }
  template <class Visit>
  void for_each_state(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    for (std::uint32_t i = first; i < last; ++i) visit(State{i});
  }
  template <class Visit>
  void for_each_state(Visit&& visit) const {
    for_each_state(0, states(), visit);
  }
  template <class Visit>
  void for_each_outcome(State s, std::uint32_t, Visit&& visit) const {
    for (std::uint32_t o = first_[s.index]; o < first_[s.index + 1]; ++o)
      visit(outcomes_[o].target, outcomes_[o].probability, outcomes_[o].marked);
  }
  template <class Visit>
  void for_each_predecessor(State s, Visit&& visit) const {
    for (std::uint32_t i = first_source_[s.index]; i < first_source_[s.index + 1]; ++i) visit(State{sources_[i]});
  }

 private:
  struct Outcome {
    std::uint32_t target;
    double probability;
    bool marked;
  };
  void finish();

  std::vector<std::uint32_t> origin_, first_, first_source_, sources_, blocks_;
  std::vector<Outcome> outcomes_;
  std::vector<double> cost_;
  std::vector<bool> goal_;
};

}  // namespace waymark::plan
