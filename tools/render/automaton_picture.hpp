// Automata and other graphs: DOT laid out by the helper executable waymark-layout, embedded as nested <svg>.
#pragma once
#include <cstddef>
#include <optional>
#include <stop_token>
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

// A graph that has more cannot be read, and may take minutes to lay out.
constexpr std::size_t most_drawn_states = 100, most_drawn_edges = 250;

struct Layout {  // of a graph
  // Attributes that override those of the text: from top to bottom, beside a map.
  std::vector<std::string> attributes{"rankdir=TB", "nodesep=0.5", "ranksep=0.6"};
  std::size_t edges = most_drawn_edges;  // at most
  double seconds = 20;                   // of work
  std::stop_token stop = {};
};
// nullopt when the helper is not installed. Throws tools::GaveUp, with advice, for a graph of more edges before
// anything is laid out, after so many seconds, and when it is stopped; std::runtime_error when the helper fails.
std::optional<Drawing> lay_out(const std::string& dot, const Layout& layout = {});
// The same of a part of a picture, which may be left out: then `left_out` says why. Throws tools::GaveUp when stopped.
std::optional<Drawing> lay_out_or_leave_out(const std::string& dot, const Layout& layout, std::string& left_out);
// A complete SVG document of one drawing.
std::string alone(const Drawing& drawing);

// Scaled to fit the box, never enlarged, centred in it.
void embed(Svg& svg, const Drawing& drawing, Point corner, double width, double height);

}  // namespace waymark::render
