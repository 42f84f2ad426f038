// Small drawings of what stands in hallways and hangs on their walls, as vector paths of our own.
#pragma once
#include <string_view>

#include "tools/render/svg.hpp"

namespace waymark::render {

// Furniture in a square of side `size` around `centre`; a name without a drawing is shown by its first two letters.
void draw_object(Svg& svg, std::string_view object, Point centre, double size);
// A framed painting, 1.25 × as wide as high.
void draw_painting(Svg& svg, std::string_view painting, Point centre, double height);

}  // namespace waymark::render
