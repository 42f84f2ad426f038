// Small drawings of what stands in hallways and hangs on their walls, as vector paths of our own.
#pragma once
#include <string_view>

#include "tools/render/svg.hpp"

namespace waymark::render {

bool has_drawing(std::string_view object);
// Whether a name without a drawing is short enough to be written out where the object stands.
bool is_written_out(std::string_view object);
// Furniture in a square of side `size` around `centre`. A name without a drawing is written out where it is short
// enough, in lines at most 60 wide, else shown by its first two letters.
void draw_object(Svg& svg, std::string_view object, Point centre, double size);
// A framed painting, 1.25 × as wide as high.
void draw_painting(Svg& svg, std::string_view painting, Point centre, double height);

}  // namespace waymark::render
