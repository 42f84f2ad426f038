// Blocks of a product made ready to be solved, side by side: the order of their unknowns, and their grid. Values come
// in later, block after block.
#pragma once
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "libltl/parallel.hpp"
#include "libplan/solve/grid_block.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/strategy_chain.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

template <class Product, Measure measure>
class ReadyBlocks {  // all of them must outlive it
 public:
  using Compact = typename Product::Compact;
  struct Ready {                    // a block
    SweepOrder<Compact> order;      // of its unknowns, or none and a grid of them
    std::optional<GridBlock> grid;  // that is swept in place
  };

  ReadyBlocks(const Product& product, const Unknowns& unknowns, const EndComponentQuotient<Product>& merged,
              const IterationOptions& limits)
      : product_(product), unknowns_(unknowns), merged_(merged), limits_(limits) {}

  // From block `b` on: many at once where they are small. O(outcomes); 22 bytes a state of a grid.
  std::vector<Ready> some(std::size_t b) const {
    constexpr std::uint32_t most_states = 1U << 23U;
    const std::vector<std::uint32_t>& blocks = product_.blocks();
    std::size_t end = b + 1;
    while (end + 1 < blocks.size() && blocks[end + 1] - blocks[b] <= most_states) ++end;
    std::vector<Ready> out(end - b);
    ltl::parallel_for(out.size(), limits_.sweepers.free(),
                      [&](std::size_t i, std::size_t) { make(out[i], blocks[b + i], blocks[b + i + 1]); });
    return out;
  }

 private:
  static constexpr bool is_grid =
      std::is_same_v<Product, GridBlock::Product> || std::is_same_v<Product, StrategyChain<GridBlock::Product>>;

  void make(Ready& out, std::uint32_t first, std::uint32_t last) const {
    out.order = merged_.in_order(first, last);
    if constexpr (is_grid) {
      if (out.order.states.size() <= limits_.on_grid || limits_.policy_iteration) return;
      if (auto made = grid(std::move(out.order)))
        out.grid.emplace(std::move(*made));
      else
        out.order = merged_.in_order(first, last);
    }
  }

  std::optional<GridBlock> grid(SweepOrder<Compact> order) const {
    const auto of = [&](const GridBlock::Product& product, const Strategy* only) {
      return GridBlock::of(product, unknowns_, measure, std::move(order), only, limits_.memory);
    };
    if constexpr (std::is_same_v<Product, GridBlock::Product>)
      return of(product_, nullptr);
    else
      return of(product_.product(), &product_.strategy());
  }

  const Product& product_;
  const Unknowns& unknowns_;
  const EndComponentQuotient<Product>& merged_;
  const IterationOptions& limits_;
};

}  // namespace waymark::plan
