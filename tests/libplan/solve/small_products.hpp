// Small products, written out and drawn at random.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libplan/solve/reachability.hpp"

namespace waymark::plan::testing {

// Has the public face of ProductMdp that solvers ask for.
struct SmallProduct {
  static constexpr std::uint32_t trap = UINT32_MAX;
  struct State {
    std::uint32_t index;
  };
  struct Compact {
    std::uint32_t number;
  };
  struct Outcome {
    std::uint32_t target;
    double probability;
  };
  struct Choice {
    double cost;
    std::vector<Outcome> outcomes;
  };
  std::vector<std::vector<Choice>> of;  // by state
  std::vector<std::uint32_t> ranges;

  std::uint32_t states() const { return static_cast<std::uint32_t>(of.size()); }
  State state(std::uint32_t i) const { return {i}; }
  State state(Compact c) const { return {c.number}; }
  Compact compact(State s) const { return {s.index}; }
  const std::vector<std::uint32_t>& blocks() const { return ranges; }
  std::uint32_t choices(State s) const { return static_cast<std::uint32_t>(of[s.index].size()); }
  double cost(State s, std::uint32_t k) const { return of[s.index][k].cost; }
  template <class Visit>
  void for_each_state(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    for (std::uint32_t i = first; i < last; ++i) visit(State{i});
  }
  template <class Visit>
  void for_each_state(Visit&& visit) const {
    for_each_state(0, states(), visit);
  }
  template <class Visit>
  void for_each_outcome(State s, std::uint32_t k, Visit&& visit) const {
    for (const Outcome& o : of[s.index][k].outcomes) visit(o.target, o.probability, false);
  }
  template <class Visit>
  void for_each_predecessor(State s, Visit&& visit) const {
    for (std::uint32_t i = 0; i < states(); ++i)
      if (leads(i, s.index)) visit(State{i});
  }
  bool leads(std::uint32_t from, std::uint32_t to) const {  // by some choice, with some chance
    return std::any_of(of[from].begin(), of[from].end(), [&](const Choice& choice) {
      return std::any_of(choice.outcomes.begin(), choice.outcomes.end(),
                         [&](const Outcome& o) { return o.target == to; });
    });
  }
};

// Blocks that no outcome leaves upwards; now and then a state without a choice. Chances in quarters, costs of some
// choices nothing.
inline SmallProduct small_product(ltl::Random& random, std::uint32_t states, std::uint32_t most_choices = 3) {
  SmallProduct out;
  out.ranges = {0};
  for (std::uint32_t i = 1; i < states; ++i)
    if (random.below(5) == 0) out.ranges.push_back(i);
  out.ranges.push_back(states);
  for (std::uint32_t i = 0; i < states; ++i) {
    const std::uint32_t below = *std::upper_bound(out.ranges.begin(), out.ranges.end(), i);
    const auto target = [&] {
      return random.below(12) == 0 ? SmallProduct::trap : static_cast<std::uint32_t>(random.below(below));
    };
    auto& choices = out.of.emplace_back();
    for (std::size_t k = random.below(16) == 0 ? 0 : 1 + random.below(most_choices); k > 0; --k) {
      SmallProduct::Choice& choice = choices.emplace_back();
      choice.cost = random.below(3) == 0 ? 0 : static_cast<double>(1 + random.below(3));
      const double p = 0.25 * static_cast<double>(1 + random.below(4));
      choice.outcomes.push_back({target(), p});
      if (p < 1) choice.outcomes.push_back({target(), 1 - p});
    }
  }
  return out;
}

inline StateSet random_states(ltl::Random& random, std::uint32_t states, std::size_t one_in) {
  StateSet out(states);
  for (std::uint32_t i = 0; i < states; ++i) out.set(i, random.below(one_in) == 0);
  return out;
}

inline std::string show(const SmallProduct& product) {  // "2: cost 1 → 0.5·0 0.5·trap"
  std::string out;
  for (std::uint32_t i = 0; i < product.states(); ++i)
    for (const SmallProduct::Choice& choice : product.of[i]) {
      out += std::to_string(i) + ": cost " + std::to_string(choice.cost) + " →";
      for (const SmallProduct::Outcome& o : choice.outcomes)
        out += " " + std::to_string(o.probability) + "·" +
               (o.target == SmallProduct::trap ? std::string("trap") : std::to_string(o.target));
      out += "\n";
    }
  for (const std::uint32_t first : product.ranges) out += "block " + std::to_string(first) + "\n";
  return out;
}

}  // namespace waymark::plan::testing
