#include "tools/render/floors.hpp"

#include <algorithm>
#include <array>

namespace waymark::render {
namespace {

struct Pattern {
  std::string_view floor;
  double width, height;      // of the tile
  std::string_view ground;   // colour
  std::string_view drawing;  // SVG inside the tile
};

constexpr std::array patterns{
    Pattern{"blue", 16, 8, "#8fc1e6",
            R"(<path d="M-4 4 Q0 1 4 4 T12 4 T20 4" fill="none" stroke="#4d8fc4" stroke-width="1.1"/>)"},
    Pattern{"brick", 16, 12, "#cf7a58",
            R"(<path d="M0 0.5 H16 M0 6.5 H16 M4 0.5 V6.5 M12 6.5 V12.5" stroke="#f6e3d8" stroke-width="1.2"/>)"},
    Pattern{"concrete", 17, 13, "#d3d3d1",
            R"(<g fill="#a9a9a6"><circle cx="3" cy="3" r="0.8"/><circle cx="11" cy="5.5" r="0.6"/>)"
            R"(<circle cx="6" cy="10" r="0.7"/><circle cx="15" cy="11" r="0.5"/></g>)"},
    Pattern{"flower", 18, 18, "#f7dbe6",
            R"(<g fill="#c74f86"><circle cx="9" cy="6.4" r="1.9"/><circle cx="11.5" cy="8.2" r="1.9"/>)"
            R"(<circle cx="10.5" cy="11.1" r="1.9"/><circle cx="7.5" cy="11.1" r="1.9"/>)"
            R"(<circle cx="6.5" cy="8.2" r="1.9"/>)"
            R"(</g><circle cx="9" cy="9" r="1.5" fill="#fff3b0"/>)"},
    Pattern{"grass", 14, 12, "#9dc46c",
            R"(<path d="M3 6 L2 2.5 M3 6 L4.4 2 M10 11.5 L9 8 M10 11.5 L11.4 7.5" stroke="#3f7a1f" )"
            R"(stroke-width="1.2" stroke-linecap="round"/>)"},
    Pattern{
        "gravel", 15, 14, "#6b6b6e",
        R"(<g fill="#b9b9bd"><ellipse cx="4" cy="3.5" rx="2.4" ry="1.7"/><ellipse cx="11" cy="5.5" rx="1.8" ry="1.4"/>)"
        R"(<ellipse cx="5.5" cy="10" rx="1.7" ry="1.4"/><ellipse cx="12" cy="11.5" rx="2.2" ry="1.5"/></g>)"},
    Pattern{"wood", 28, 16, "#dcb179",
            R"(<path d="M0 0.5 H28 M0 8.5 H28 M7 0.5 V8.5 M21 8.5 V16.5" stroke="#8a5a24" stroke-width="1.1"/>)"
            R"(<path d="M11 4.5 H24 M2 12.5 H15" stroke="#b98a4f" stroke-width="0.9"/>)"},
    Pattern{"yellow", 12.12, 21, "#fbe588",
            R"(<path d="M6.06 0 V3.5 L12.12 7 V14 L6.06 17.5 V21 M6.06 3.5 L0 7 V14 L6.06 17.5" fill="none" )"
            R"(stroke="#b98b00" stroke-width="1.1"/>)"},
};

// For floors that have no drawing of their own: hatchings, told apart by direction, distance and ground.
constexpr std::array hatchings{
    Pattern{"", 8, 8, "#e8eef7", R"(<path d="M-2 2 L2 -2 M0 8 L8 0 M6 10 L10 6" stroke="#35507a" stroke-width="1"/>)"},
    Pattern{"", 8, 8, "#f7efe3", R"(<path d="M-2 6 L2 10 M0 0 L8 8 M6 -2 L10 2" stroke="#7a5a1d" stroke-width="1"/>)"},
    Pattern{"", 7, 7, "#e6f3ea", R"(<path d="M0 3.5 H7" stroke="#2f6b45" stroke-width="1"/>)"},
    Pattern{"", 7, 7, "#f3e6f0", R"(<path d="M3.5 0 V7" stroke="#70325f" stroke-width="1"/>)"},
    Pattern{"", 9, 9, "#ececec", R"(<path d="M0 4.5 H9 M4.5 0 V9" stroke="#555" stroke-width="0.9"/>)"},
};

const Pattern& pattern_of(const std::vector<std::string>& floors, std::size_t index) {
  const auto* known =
      std::find_if(patterns.begin(), patterns.end(), [&](const Pattern& p) { return p.floor == floors[index]; });
  return known != patterns.end() ? *known : hatchings[index % hatchings.size()];
}

}  // namespace

void define_floors(Svg& svg, const std::vector<std::string>& floors) {
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const Pattern& p = pattern_of(floors, i);
    svg.open("pattern", "id=\"waymark-floor-" + std::to_string(i) + "\" patternUnits=\"userSpaceOnUse\" width=\"" +
                            number(p.width) + "\" height=\"" + number(p.height) + '"');
    svg.rectangle({0, 0}, p.width, p.height, "fill=\"" + std::string(p.ground) + '"');
    svg.raw(p.drawing);
    svg.close("pattern");
  }
}

std::string floor_fill(const std::vector<std::string>& floors, std::string_view floor) {
  const auto position = std::find(floors.begin(), floors.end(), floor) - floors.begin();
  return "fill=\"url(#waymark-floor-" + std::to_string(position) + ")\"";
}

}  // namespace waymark::render
