// States in an order, in parts that are swept side by side, each in this order.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/grid_cut.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

struct OrderedParts {
  std::vector<std::uint32_t> states;              // part after part
  std::vector<std::uint32_t> begin;               // by part, and of one more: where it begins among them
  std::vector<std::vector<std::uint32_t>> first;  // by part, by chunk of the order, and of one more: likewise
  std::size_t chunks = 0;                         // of the order

  std::size_t count() const { return first.size(); }  // of parts
  std::uint32_t part(std::uint32_t at) const {        // of a place among the states
    return static_cast<std::uint32_t>(std::upper_bound(begin.begin(), begin.end(), at) - begin.begin() - 1);
  }
  std::uint32_t chunk(std::uint32_t part, std::uint32_t at) const {  // of the order
    const std::vector<std::uint32_t>& own = first[part];
    return static_cast<std::uint32_t>(std::upper_bound(own.begin(), own.end(), at) - own.begin() - 1);
  }

  // Strips of a grid; of other models equal ranges of states. O(states).
  template <class Product>
  static OrderedParts of(const Product& product, const SweepOrder<std::uint32_t>& order) {
    const std::vector<std::uint32_t>& all = order.states;
    if constexpr (std::is_same_v<Product, ProductMdp<GridWorld>>) {
      std::vector<ProductState> places;
      for (const std::uint32_t i : all) places.push_back(product.compact(product.state(i)));
      const GridCut cut = GridCut::of(product.model(), places, order.chunk_size());
      return OrderedParts(order, cut.strips, [&](std::size_t i) { return cut.strip(places[i].place); });
    } else {
      const std::size_t parts = GridCut::strips_for(all.size(), order.chunk_size()), states = product.states();
      return OrderedParts(order, parts,
                          [&](std::size_t i) { return static_cast<std::uint32_t>(all[i] * parts / states); });
    }
  }

 private:
  template <class PartOf>
  OrderedParts(const SweepOrder<std::uint32_t>& order, std::size_t parts, const PartOf& part_of)
      : begin(parts + 1, 0), first(parts) {
    const std::size_t size = order.chunk_size();
    chunks = (order.states.size() + size - 1) / size;
    for (std::size_t i = 0; i < order.states.size(); ++i) ++begin[part_of(i) + 1];
    for (std::size_t p = 0; p < parts; ++p) begin[p + 1] += begin[p];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    states.resize(order.states.size());
    for (std::size_t i = 0; i < order.states.size(); ++i) {
      if (i % size == 0)
        for (std::size_t p = 0; p < parts; ++p) first[p].push_back(next[p]);
      states[next[part_of(i)]++] = order.states[i];
    }
    for (std::size_t p = 0; p < parts; ++p) first[p].push_back(next[p]);
  }
};

}  // namespace waymark::plan
