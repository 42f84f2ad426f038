// Maximal end components: where a strategy can stay for ever, and move about as it likes. [BK08, Alg. 47]
//
// Components of the graph whose edges are the usable choices that stay within one component of the last round, until
// all of these stay within one of this round. Before each round, states that no usable choice keeps inside are taken
// out, and those that then have none; so all that are left are in a component of the round. O(edges · rounds); 12 bytes
// a state.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "libplan/solve/end_components_round.hpp"

namespace waymark::plan {

// Do all usable choices that stayed stay, too, in the components that were found among them?
template <class Product, class Usable>
bool have_same_edges(const Product& product, const EndComponents& last, const EndComponents& found,
                     const Usable& usable, std::size_t threads) {
  std::atomic<bool> same{true};
  for_each_state(product, threads, [&](const auto& s) {
    const std::uint32_t own = found.of[s.index];
    if (own == EndComponents::none || !same.load(std::memory_order_relaxed)) return;
    bool all = true;
    for_each_target(product, s, [&](std::uint32_t t) { all = all && t != Product::trap && found.of[t] == own; });
    for (std::uint32_t k = 0; k < product.choices(s) && !all; ++k)
      if (usable(s, k) && stays(product, s, k, last) && !stays(product, s, k, found))
        same.store(false, std::memory_order_relaxed);
  });
  return same;
}

// Within a set of states, by choices that are usable(state, choice). Several threads take states out; the components
// themselves are found by one.
template <class Product, class Usable>
EndComponents end_components(const Product& product, const StateSet& within, const Usable& usable,
                             std::size_t threads = 1) {
  EndComponents found{std::vector<std::uint32_t>(product.states(), EndComponents::none)};
  StateSet inside = within;
  for (std::uint32_t i = 0; i < product.states(); ++i)
    if (within[i]) found.of[i] = 0;
  for (;;) {
    const auto keeps = [&](const auto& s) {
      bool kept = false;
      for (std::uint32_t k = 0; k < product.choices(s) && !kept; ++k) {
        kept = usable(s, k);
        product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) {
          kept = kept && t != Product::trap && inside[t] && found.of[t] == found.of[s.index];
        });
      }
      return kept;
    };
    prune(product, inside, keeps, threads);
    for (std::uint32_t i = 0; i < product.states(); ++i)
      if (!inside[i]) found.of[i] = EndComponents::none;
    const EndComponents last = std::move(found);
    found = EndComponentsRound(product, last, usable).run();
    if (have_same_edges(product, last, found, usable, threads)) return found;
  }
}

}  // namespace waymark::plan
