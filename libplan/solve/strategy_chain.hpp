// The Markov chain that a strategy makes of a product, implicit, with the public interface of ProductMdp.
// Its states are the states of the product that the strategy meets, with the same numbers; outcomes are computed on
// demand. A state of the product takes one bit. Hence the solvers of products evaluate a strategy block after block, in
// the order of the product, and grids in place.
#pragma once
#include <cstdint>
#include <vector>

#include "libplan/solve/reachability.hpp"
#include "libplan/solve/strategy.hpp"

namespace waymark::plan {

// Product and strategy must outlive it.
template <class Product>
class StrategyChain {
 public:
  using State = typename Product::State;
  using Compact = typename Product::Compact;
  static constexpr std::uint32_t trap = Product::trap;  // no state

  StrategyChain(const Product& product, const Strategy& strategy)
      : product_(product), strategy_(strategy), met_(product.states()) {
    std::vector<Compact> open{product.compact(product.state(strategy.start))};
    met_.insert(strategy.start);
    while (!open.empty()) {
      const State s = product.state(open.back());
      open.pop_back();
      for_each_outcome(s, 0, [&](std::uint32_t t, double, bool) {
        if (t == trap || met_[t]) return;
        met_.insert(t);
        open.push_back(product.compact(product.state(t)));
      });
    }
  }

  const Product& product() const { return product_; }     // in which the strategy chooses
  const Strategy& strategy() const { return strategy_; }  // that was given
  bool meets(std::uint32_t i) const { return met_[i]; }   // is the state of the product met?

  std::uint32_t states() const { return product_.states(); }  // those never met among them
  // What the interface of ProductMdp asks.
  State state(std::uint32_t i) const { return product_.state(i); }
  State state(Compact c) const { return product_.state(c); }
  Compact compact(const State& s) const { return product_.compact(s); }
  const std::vector<std::uint32_t>& blocks() const { return product_.blocks(); }
  bool is_goal(const State& s) const { return product_.is_goal(s); }
  bool has_marks() const { return product_.has_marks(); }  // may an edge be marked?
  std::uint32_t choices(const State&) const { return 1; }
  double cost(const State& s, std::uint32_t) const {
    const std::uint32_t k = strategy_.choice[s.index];
    return k == Strategy::none ? 0 : product_.cost(s, k);
  }
  template <class Visit>  // those that are met
  void for_each_state(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    product_.for_each_state(first, last, [&](const State& s) {
      if (met_[s.index]) visit(s);
    });
  }
  // Visits the states that the strategy meets.
  template <class Visit>
  void for_each_state(Visit&& visit) const {
    for_each_state(0, states(), visit);
  }
  template <class Visit>  // where the strategy makes no choice the chain stays, at no cost
  void for_each_outcome(const State& s, std::uint32_t, Visit&& visit) const {
    const std::uint32_t k = strategy_.choice[s.index];
    if (k == Strategy::none)
      visit(s.index, 1.0, false);
    else
      product_.for_each_outcome(s, k, visit);
  }
  // Visits the states from which the strategy leads here.
  template <class Visit>
  void for_each_predecessor(const State& s, Visit&& visit) const {
    product_.for_each_predecessor(s, [&](const State& source) {
      if (met_[source.index]) visit(source);
    });
  }

 private:
  const Product& product_;
  const Strategy& strategy_;
  StateSet met_;
};

}  // namespace waymark::plan
