#include "libplan/solve/grid_strips.hpp"

#include <algorithm>
#include <utility>

namespace waymark::plan {

GridStrips::GridStrips(const GridWorld& grid, const Order& order, std::size_t chunk_size)
    : cut_(GridCut::of(grid, order, chunk_size)),
      length_(cut_.by_columns ? grid.height() : grid.width()),
      cells_(order.size()),
      chunks_((order.size() + chunk_size - 1) / chunk_size),
      strips_(cut_.strips) {
  const auto lines = static_cast<std::uint32_t>(cut_.strip_of.size());
  slots_ = (lines + 2 * static_cast<std::uint32_t>(count())) * length_;
  const auto along = static_cast<std::int32_t>(length_);
  steps_ = cut_.by_columns ? std::array<std::int32_t, 4>{-1, along, 1, -along}
                           : std::array<std::int32_t, 4>{-along, 1, along, -1};
  const auto place = [&](std::uint32_t line) { return line + 1 + 2 * cut_.strip_of[line]; };
  for (std::uint32_t line = 0; line < lines; ++line) strips_[cut_.strip_of[line]].last_line = place(line);
  for (std::uint32_t line = lines; line-- > 0;) strips_[cut_.strip_of[line]].first_line = place(line);
  std::vector<std::size_t> cells(count(), 0);
  for (const ProductState& s : order) ++cells[cut_.strip(s.place)];
  for (std::size_t s = 0; s < count(); ++s) strips_[s].slots.reserve(cells[s]);
  std::vector<PlaceOfCopy> copies;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto chunk = static_cast<std::uint32_t>(i / chunk_size);
    if (i % chunk_size == 0)
      for (Strip& strip : strips_) strip.first.push_back(static_cast<std::uint32_t>(strip.slots.size()));
    const std::uint32_t at = slot(order[i].place), s = cut_.strip(order[i].place);
    Strip& strip = strips_[s];
    strip.slots.push_back(at);
    if (s > 0 && at / length_ == strip.first_line) copies.push_back({s, s - 1, chunk, at, at - 2 * length_});
    if (s + 1 < count() && at / length_ == strip.last_line) copies.push_back({s, s + 1, chunk, at, at + 2 * length_});
  }
  for (Strip& strip : strips_) strip.first.push_back(static_cast<std::uint32_t>(strip.slots.size()));
  exchange_ = Exchange<double>(count(), chunks_, std::move(copies));
}

}  // namespace waymark::plan
