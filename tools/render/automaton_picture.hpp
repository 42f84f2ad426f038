// Automata and other graphs: DOT laid out by the helper executable waymark-layout, embedded as nested <svg>.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/render/svg.hpp"

namespace waymark::render {

struct Drawing {
  double width = 0, height = 0;  // natural size in pixels
  std::string content;           // SVG elements in a viewport of that size
};

// An SVG document as a drawing: its viewBox and what is inside the root element. Throws std::runtime_error when the
// text has no <svg viewBox="0 0 w h"> root.
Drawing drawing_of(std::string_view svg);

// Attributes of the graph that override those of the text: from top to bottom, beside a map.
inline const std::vector<std::string> upright{"rankdir=TB", "nodesep=0.5", "ranksep=0.6"};
// nullopt when the helper is not installed. Throws std::runtime_error when it fails.
std::optional<Drawing> lay_out(const std::string& dot, const std::vector<std::string>& attributes = upright);
// A complete SVG document of one drawing.
std::string alone(const Drawing& drawing);

// Scaled to fit the box, never enlarged, centred in it.
void embed(Svg& svg, const Drawing& drawing, Point corner, double width, double height);

}  // namespace waymark::render
