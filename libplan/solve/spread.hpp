// All states of a product looked at by several threads, and searches backwards among them.
//
// Product: anything with the public face of ProductMdp. What is found must not depend on the order: sets that only
// grow, or only shrink.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "libltl/parallel.hpp"
#include "libplan/product/shared_work.hpp"
#include "libplan/solve/state_set.hpp"

namespace waymark::plan {

// Numbers of states in ranges that threads take turns at. No word of a StateSet belongs to two of them.
struct StateRanges {
  static constexpr std::uint32_t length = 256 * StateSet::in_a_word;  // numbers of a range
  std::uint32_t states = 0;                                           // of the product

  std::size_t count() const { return (std::size_t{states} + length - 1) / length; }  // of ranges
  // Threads of those that are there: one where starting others would take longer.
  std::size_t threads(std::size_t there) const { return count() < 4 ? 1 : std::min(there, count()); }
  template <class Product, class Visit>  // visit(state), of one range
  void for_each(std::size_t range, const Product& product, Visit&& visit) const {
    const auto first = static_cast<std::uint32_t>(range * length);
    product.for_each_state(first, std::min(first + length, states), visit);
  }
};

// visit(state), side by side.
template <class Product, class Visit>
void for_each_state(const Product& product, std::size_t threads, const Visit& visit) {
  const StateRanges ranges{product.states()};
  ltl::parallel_for(ranges.count(), ranges.threads(threads),
                    [&](std::size_t range, std::size_t) { ranges.for_each(range, product, visit); });
}

// first(state), of all states, and look_at(state), of the predecessors of those that joined: does it join now? Of
// several threads that ask at once one is told so.
template <class Product, class First, class LookAt>
void spread(const Product& product, std::size_t threads, const First& first, const LookAt& look_at) {
  using Compact = typename Product::Compact;
  const StateRanges ranges{product.states()};
  const auto begin = [&](std::size_t range, const auto& put) {
    ranges.for_each(range, product, [&](const auto& s) {
      if (first(s)) put(product.compact(s));
    });
  };
  const auto expand = [&](const Compact& joined, const auto& put, std::size_t) {
    product.for_each_predecessor(product.state(joined), [&](const auto& source) {
      if (look_at(source)) put(product.compact(source));
    });
    return true;
  };
  search_together<Compact>(ranges.count(), ranges.threads(threads), begin, expand);
}

}  // namespace waymark::plan
