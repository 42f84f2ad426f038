// The legend of a picture: the meaning of the marks that occur on the map.
#pragma once
#include <cstdint>

#include "libplan/world/map.hpp"
#include "tools/render/svg.hpp"

namespace waymark::render {

// What the legend explains of a route: nothing, its ends, or where the cycle of a lasso begins.
enum class RouteMarks : std::uint8_t { None, Route, Lasso };

// Height that draw_legend needs for this width.
double legend_height(const plan::Map& map, double width, RouteMarks marks);
void draw_legend(Svg& svg, const plan::Map& map, Point corner, double width, RouteMarks marks);

}  // namespace waymark::render
