// The legend of a picture: the meaning of the marks that occur on the map.
#pragma once
#include "libplan/world/map.hpp"
#include "tools/render/svg.hpp"

namespace waymark::render {

// Height that draw_legend needs for this width.
double legend_height(const plan::Map& map, double width, bool with_route);
void draw_legend(Svg& svg, const plan::Map& map, Point corner, double width, bool with_route);

}  // namespace waymark::render
