#include "tools/render/page.hpp"

#include <algorithm>

#include "tools/render/floors.hpp"
#include "tools/render/legend.hpp"
#include "tools/render/map_picture.hpp"
#include "tools/render/motion_picture.hpp"
#include "tools/render/route_picture.hpp"

namespace waymark::render {
namespace {

constexpr double border = 28, gutter = 34, least_panel = 400, greatest_panel = 620;
constexpr double instruction_size = 21, formula_size = 16, caption_size = 13;

struct Line {
  std::string text;
  double size;
  std::string_view style;
};

std::vector<Line> title_lines(const Page& page, double width) {
  std::vector<Line> lines;
  const auto add = [&](const std::string& text, double size, double measure, std::string_view style) {
    for (std::string& line : wrapped(text, width / size / measure)) lines.push_back({std::move(line), size, style});
  };
  if (!page.instruction.empty())
    add("“" + page.instruction + "”", instruction_size, 1.1, R"(font-weight="bold" fill="#20242b")");
  if (!page.formula.empty()) add(drawable(page.formula), formula_size, 1, R"(fill="#1c3f7c")");
  if (!page.caption.empty()) add(page.caption, caption_size, 1, R"(fill="#5c5c5c")");
  return lines;
}

double line_step(const Line& line) { return line.size * 1.4; }

double height_of(const std::vector<Line>& lines) {
  double height = 0;
  for (const Line& line : lines) height += line_step(line);
  return lines.empty() ? 0 : height + 14;
}

void draw_title(Svg& svg, const std::vector<Line>& lines) {
  double y = border;
  for (const Line& line : lines) {
    y += line_step(line);
    svg.text({border, y - line.size * 0.35}, line.size, line.text, line.style);
  }
}

struct Panel {  // automaton above legend
  double width, automaton_height, legend_height;
  double height() const { return automaton_height + legend_height; }
};

constexpr double automaton_heading = 40;  // its heading above and a gap below

RouteMarks marks_of(const Page& page) {
  if (!page.route) return RouteMarks::None;
  return page.repeated > 0 ? RouteMarks::Lasso : RouteMarks::Route;
}

Panel panel_of(const Page& page, double map_height) {
  Panel panel{least_panel, 0, 0};
  if (page.automaton) panel.width = std::clamp(page.automaton->width, least_panel, greatest_panel);
  panel.legend_height = legend_height(*page.map, panel.width, marks_of(page)) + 64;  // the compass
  if (page.automaton) {
    const double natural = page.automaton->height * std::min(1.0, panel.width / page.automaton->width);
    const double room = std::max(320.0, map_height - panel.legend_height - automaton_heading);
    panel.automaton_height = std::min(natural, room) + automaton_heading;
  }
  return panel;
}

void draw_panel(Svg& svg, const Page& page, const Panel& panel, Point corner) {
  Point below = corner;
  if (page.automaton) {
    svg.text({corner.x, corner.y + 14}, 13, "Automaton", R"(font-weight="bold" fill="#20242b")");
    svg.text({corner.x + 94, corner.y + 14}, 13, page.automaton_caption, R"(fill="#5c5c5c")");
    embed(svg, *page.automaton, {corner.x, corner.y + 24}, panel.width, panel.automaton_height - automaton_heading);
    below.y += panel.automaton_height;
  }
  draw_legend(svg, *page.map, below, panel.width, marks_of(page));
  draw_compass(svg, {below.x + 14, below.y + panel.legend_height - 26});
}

}  // namespace

std::string drawable(std::string formula) {
  constexpr std::pair<std::string_view, std::string_view> plain[]{{"𝒰", "U"}, {"ℛ", "R"}, {"𝒲", "W"}, {"ℳ", "M"}};
  for (const auto& [script, letter] : plain)
    for (auto found = formula.find(script); found != std::string::npos; found = formula.find(script, found))
      formula.replace(found, script.size(), letter);
  return formula;
}

void open_document(Svg& svg, double width, double height) {
  svg.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  svg.open_picture(width, height);
}

std::string draw_page(const Page& page) {
  PlanView view(*page.map);
  const Panel panel = panel_of(page, view.height());
  const double width = 2 * border + view.width() + gutter + panel.width;
  const auto lines = title_lines(page, width - 2 * border);
  const double top = border + height_of(lines);
  const double height = top + std::max(view.height(), panel.height()) + border;

  Svg svg;
  open_document(svg, width, height);
  svg.open("defs");
  define_floors(svg, page.map->floors());
  svg.close("defs");
  draw_title(svg, lines);
  svg.open("g", translated({border, top}));
  draw_map(svg, view);
  if (page.route) draw_route(svg, view, *page.route, page.repeated);
  if (page.motion) draw_motion(svg, {view.centre(0.0, 0.0), PlanView::cell}, page.motion->motion());
  draw_place_numbers(svg, view);
  svg.close("g");
  draw_panel(svg, page, panel, {border + view.width() + gutter, top + 4});
  svg.close("svg");
  return svg.str();
}

}  // namespace waymark::render
