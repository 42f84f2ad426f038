#include "tools/render/automaton_picture.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <vector>

#include "libltl/watch.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/process.hpp"

namespace waymark::render {
namespace {

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> values;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" ,"), text.size()));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return values;
    values.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

// Lines of our DOT texts that hold an edge; a label may hold an arrow, too.
std::size_t edges_of(std::string_view dot) {
  std::size_t edges = 0;
  while (!dot.empty()) {
    const std::string_view line = dot.substr(0, dot.find('\n'));
    if (line.substr(0, line.find_first_of("[\"")).find("->") != std::string_view::npos) ++edges;
    dot.remove_prefix(std::min(line.size() + 1, dot.size()));
  }
  return edges;
}

}  // namespace

Drawing drawing_of(std::string_view svg) {
  constexpr std::string_view key = "viewBox=\"";
  const auto root = svg.find("<svg");
  const auto root_end = root == std::string_view::npos ? root : svg.find('>', root);
  const auto box = root == std::string_view::npos ? root : svg.find(key, root);
  const auto close = svg.rfind("</svg>");
  if (root_end == std::string_view::npos || box == std::string_view::npos || box > root_end ||
      close == std::string_view::npos || close < root_end)
    throw std::runtime_error("the picture of the automaton is not an SVG document");
  const auto from = box + key.size();
  const auto values = numbers_in(svg.substr(from, svg.find('"', from) - from));
  if (values.size() != 4) throw std::runtime_error("the picture of the automaton has no size");
  return {values[2], values[3], std::string(svg.substr(root_end + 1, close - root_end - 1))};
}

std::optional<Drawing> lay_out(const std::string& dot, const Layout& layout) {
  const auto program = tools::helper("waymark-layout");
  if (program.empty()) return std::nullopt;
  if (edges_of(dot) > layout.edges)
    throw tools::GaveUp("not drawn: more than " + std::to_string(layout.edges) +
                        " edges; --format dot gives the graph as text, for other tools");
  const ltl::Watch watch({.seconds = layout.seconds}, layout.stop);
  try {
    const auto finished = tools::run_helper(program, layout.attributes, dot, watch.token());
    if (finished.exit_code != 0)
      throw std::runtime_error("waymark-layout ended with exit code " + std::to_string(finished.exit_code));
    return drawing_of(finished.output);
  } catch (const tools::HelperStopped&) {
    if (watch.overrun() == ltl::Overrun::None) throw tools::GaveUp("stopped before the picture was laid out");
    throw tools::GaveUp("not drawn: the layout takes more than " + number(layout.seconds) +
                        " s; --format dot gives the graph as text, for other tools");
  }
}

std::optional<Drawing> lay_out_or_leave_out(const std::string& dot, const Layout& layout, std::string& left_out) {
  try {
    auto drawing = lay_out(dot, layout);
    if (!drawing) left_out = "waymark-layout is not installed";
    return drawing;
  } catch (const tools::GaveUp& refused) {
    if (layout.stop.stop_requested()) throw;
    left_out = refused.what();
    return std::nullopt;
  }
}

std::string alone(const Drawing& drawing) {
  constexpr double border = 16;
  Svg svg;
  svg.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  svg.open_picture(drawing.width + 2 * border, drawing.height + 2 * border);
  embed(svg, drawing, {border, border}, drawing.width, drawing.height);
  svg.close("svg");
  return svg.str();
}

void embed(Svg& svg, const Drawing& drawing, Point corner, double width, double height) {
  const double scale = std::min({1.0, width / drawing.width, height / drawing.height});
  const double w = drawing.width * scale, h = drawing.height * scale;
  svg.open("svg", "x=\"" + number(corner.x + (width - w) / 2) + "\" y=\"" + number(corner.y) + "\" width=\"" +
                      number(w) + "\" height=\"" + number(h) + "\" viewBox=\"0 0 " + number(drawing.width) + ' ' +
                      number(drawing.height) + '"');
  svg.raw(drawing.content);
  svg.close("svg");
}

}  // namespace waymark::render
