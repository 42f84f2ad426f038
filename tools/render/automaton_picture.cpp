#include "tools/render/automaton_picture.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <vector>

#include "tools/shell/data_directory.hpp"
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

std::optional<Drawing> lay_out(const std::string& dot, const std::vector<std::string>& attributes) {
  const auto program = tools::helper("waymark-layout");
  if (program.empty()) return std::nullopt;
  const auto finished = tools::run_helper(program, attributes, dot);
  if (finished.exit_code != 0)
    throw std::runtime_error("waymark-layout ended with exit code " + std::to_string(finished.exit_code));
  return drawing_of(finished.output);
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
