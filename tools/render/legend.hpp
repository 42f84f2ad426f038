// What the marks on the map mean: only those that occur on it.
#pragma once
#include "libplan/world/map.hpp"
#include "tools/render/svg.hpp"

namespace waymark::render {

// Height that draw_legend needs for this width.
double legend_height(const plan::Map& map, double width, bool with_route);
void draw_legend(Svg& svg, const plan::Map& map, Point corner, double width, bool with_route);

}  // namespace waymark::render
