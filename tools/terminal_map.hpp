// A map and a route in characters, for a terminal: places by name, hallways as lines, the route as a heavy line.
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "libplan/world/map.hpp"
#include "tools/shell/terminal.hpp"
#include "tools/shown_route.hpp"

namespace waymark::tools {

// Lines of at most `columns` characters, as long as the map has at most columns / 4 places from west to east. Names
// that have no room are cut. The start is an arrow in the direction that the route begins in, the end a ring; the cycle
// of a lasso has a line of its own. Without terminal.unicode the picture is of ASCII characters.
std::string terminal_map(const plan::Map& map, const std::optional<ShownRoute>& route, const Terminal& terminal,
                         std::size_t columns = 100);

}  // namespace waymark::tools
