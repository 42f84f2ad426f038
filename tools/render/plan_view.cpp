#include "tools/render/plan_view.hpp"

#include <algorithm>

namespace waymark::render {

Point direction(int heading) {
  switch (heading) {
    case 0: return {0, -1};
    case 90: return {1, 0};
    case 180: return {0, 1};
    default: return {-1, 0};
  }
}

PlanView::PlanView(const plan::Map& map) : map_(&map), taken_(map.nodes().size()) {
  const auto& nodes = map.nodes();
  const auto [left, right] = std::minmax_element(nodes.begin(), nodes.end(),
                                                 [](const plan::Node& a, const plan::Node& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(nodes.begin(), nodes.end(),
                                                 [](const plan::Node& a, const plan::Node& b) { return a.y < b.y; });
  min_x_ = left->x, max_x_ = right->x, min_y_ = top->y, max_y_ = bottom->y;
  width_ = 2 * margin + cell * (max_x_ - min_x_);
  height_ = 2 * margin + cell * (max_y_ - min_y_);
}

Point PlanView::centre(double x, double y) const {
  return {margin + cell * (x - min_x_), margin + cell * (y - min_y_)};
}

Point PlanView::centre(std::uint32_t node) const {
  const plan::Node& place = map_->nodes()[node];
  return centre(place.x, place.y);
}

Point PlanView::corner(std::uint32_t node, Corner where) const {
  constexpr double offset = strip / 2 + 9;
  const bool east = where == Corner::NorthEast || where == Corner::SouthEast;
  const bool south = where == Corner::SouthEast || where == Corner::SouthWest;
  const Point middle = centre(node);
  return {middle.x + (east ? offset : -offset), middle.y + (south ? offset : -offset)};
}

void PlanView::take(std::uint32_t node, Corner where) { taken_[node][static_cast<std::size_t>(where)] = true; }

Corner PlanView::take_free(std::uint32_t node) {
  const auto& taken = taken_[node];
  const auto free = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
  const auto where = static_cast<Corner>(free % taken.size());
  take(node, where);
  return where;
}

}  // namespace waymark::render
