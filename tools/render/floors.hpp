// Floor patterns: eight textures that differ in lightness and in drawing, so that they can be told apart in a grey
// print and by colour-blind readers. Floors of other maps get plain hatchings by their position in the map's list.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tools/render/svg.hpp"

namespace waymark::render {

// One <pattern> for each floor.
void define_floors(Svg& svg, const std::vector<std::string>& floors);
// `fill="url(#…)"` for one of them.
std::string floor_fill(const std::vector<std::string>& floors, std::string_view floor);

}  // namespace waymark::render
