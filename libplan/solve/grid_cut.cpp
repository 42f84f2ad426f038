#include "libplan/solve/grid_cut.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace waymark::plan {
namespace {

class Sample {  // every so many states
 public:
  Sample(const std::vector<ProductState>& order, std::size_t chunk_size)
      : order_(order), chunk_size_(chunk_size), step_(std::max<std::size_t>(1, order.size() / looked_at)) {}

  // Lines are cut where strips get equal shares; a share that no line begins is left out.
  void cut(GridCut& out, std::size_t lines, std::size_t shares) const {
    out.strip_of.assign(lines, 0);
    std::size_t all = 0, before = 0, share = 0;
    for (std::size_t i = 0; i < order_.size(); i += step_, ++all) ++out.strip_of[out.line(order_[i].place)];
    for (std::uint32_t& line : out.strip_of) {
      const std::size_t count = line,
                        own = std::min(shares - 1, (before + count / 2) * shares / std::max<std::size_t>(1, all));
      if (own > share && before > 0) ++out.strips;
      share = own;
      line = static_cast<std::uint32_t>(out.strips - 1);
      before += count;
    }
  }

  // States of the busier of two threads, chunk by chunk.
  std::size_t busiest(const GridCut& cut) const {
    std::array<std::size_t, 2> busy{};
    std::size_t sum = 0;
    for (std::size_t i = 0, chunk = 0; i < order_.size(); i += step_) {
      if (i / chunk_size_ != chunk) {
        chunk = i / chunk_size_;
        sum += std::max(busy[0], busy[1]);
        busy = {};
      }
      ++busy[cut.strip(order_[i].place) % 2];
    }
    return sum + std::max(busy[0], busy[1]);
  }

 private:
  static constexpr std::size_t looked_at = 1U << 16U;
  const std::vector<ProductState>& order_;
  std::size_t chunk_size_, step_;
};

}  // namespace

std::size_t GridCut::strips_for(std::size_t states, std::size_t chunk_size) {
  constexpr std::size_t smallest = 4'000, two_up_to = 64'000, most = 8, smallest_chunk = 100;
  if (states < smallest || chunk_size < smallest_chunk) return 1;
  return std::clamp<std::size_t>(2 * states / two_up_to, 2, most);
}

GridCut GridCut::of(const GridWorld& grid, const std::vector<ProductState>& order, std::size_t chunk_size) {
  const Sample sample(order, chunk_size);
  const std::size_t shares = strips_for(order.size(), chunk_size);
  GridCut rows{grid.width()};
  sample.cut(rows, grid.height(), shares);
  if (shares == 1) return rows;
  GridCut columns{grid.width(), true};
  sample.cut(columns, grid.width(), shares);
  return sample.busiest(columns) < sample.busiest(rows) ? std::move(columns) : std::move(rows);
}

}  // namespace waymark::plan
