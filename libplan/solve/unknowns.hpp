// The unknowns of a question about values: states without a known value, and the order in which they are solved.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "libplan/solve/end_components.hpp"

namespace waymark::plan {

// The unknowns of one question. For probabilities, states that are neither unknown nor targets have value 0; for costs
// only choices that never leave `unknown` ∪ `targets` count.
struct Unknowns {
  StateSet unknown, targets;  // without a known value; whose value is 1, or cost 0
  EndComponents merged;       // among the unknown ones
};

template <class Compact>
struct SweepOrder {             // in which states are swept
  std::vector<Compact> states;  // in this order
  std::size_t layers = 0;       // in which they were found, breadth first

  // States of four layers, on average: how far news travels in two sweeps.
  std::size_t chunk_size() const {
    return std::max<std::size_t>(64, 4 * states.size() / std::max<std::size_t>(1, layers));
  }
};

// The merged ones together.
template <class Product>
class EndComponentQuotient {
 public:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  EndComponentQuotient(const Product& product, const Unknowns& unknowns)
      : product_(product), unknowns_(unknowns), members_(unknowns.merged.count) {
    if (unknowns.merged.count == 0) return;
    product.for_each_state([&](const State& s) {
      if (component(s.index) != EndComponents::none) members_[component(s.index)].push_back(product.compact(s));
    });
  }

  std::uint32_t component(std::uint32_t i) const {  // of state i, or none
    return unknowns_.merged.count == 0 ? EndComponents::none : unknowns_.merged.of[i];
  }
  // The states of a component.
  const std::vector<Compact>& members(std::uint32_t component) const { return members_[component]; }

  // The value of a state, and of those merged with it.
  void set(const State& s, std::vector<double>& values, double value) const {
    const std::uint32_t own = component(s.index);
    if (own == EndComponents::none) {
      values[s.index] = value;
      return;
    }
    for (const Compact& member : members_[own]) values[product_.state(member).index] = value;
  }

  // The unknowns of the block, those next to what is solved first; of merged ones the first that is met.
  SweepOrder<Compact> in_order(std::uint32_t first, std::uint32_t last) const {
    std::vector<Compact> order;
    std::vector<bool> seen(last - first, false);
    std::vector<bool> met(members_.size(), false);
    std::vector<Compact> queue;
    const auto meet = [&](const State& s) {
      if (seen[s.index - first]) return;
      seen[s.index - first] = true;
      queue.push_back(product_.compact(s));
    };
    product_.for_each_state(first, last, [&](const State& s) {
      if (!unknowns_.unknown[s.index]) return;
      bool near = false;
      for_each_target(product_, s, [&](std::uint32_t t) {
        near = near || (t != Product::trap && (unknowns_.targets[t] || (unknowns_.unknown[t] && t < first)));
      });
      if (near) meet(s);
    });
    std::size_t layers = 0;
    for (std::size_t i = 0, layer = 0; i < queue.size(); ++i) {  // where nothing is merged, the queue is the order
      if (i == layer) {
        ++layers;
        layer = queue.size();
      }
      const State s = product_.state(queue[i]);
      const std::uint32_t own = component(s.index);
      if (!members_.empty() && (own == EndComponents::none || !met[own])) {
        if (own != EndComponents::none) met[own] = true;
        order.push_back(queue[i]);
      }
      product_.for_each_predecessor(s, [&](const State& source) {
        if (source.index >= first && source.index < last && unknowns_.unknown[source.index]) meet(source);
      });
    }
    return {std::move(members_.empty() ? queue : order), layers};
  }

 private:
  const Product& product_;
  const Unknowns& unknowns_;
  std::vector<std::vector<Compact>> members_;
};

}  // namespace waymark::plan
