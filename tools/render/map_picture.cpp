#include "tools/render/map_picture.hpp"

#include "tools/render/floors.hpp"
#include "tools/render/pictograms.hpp"

namespace waymark::render {
namespace {

constexpr double half = PlanView::strip / 2;
constexpr std::string_view wall_line = R"(stroke="#2b2b2b" stroke-width="2.2" stroke-linecap="square")";
constexpr std::string_view tile_fill = R"(fill="#fbfaf7")";

Point moved(Point p, Point by, double times) { return {p.x + by.x * times, p.y + by.y * times}; }

void draw_hallway(Svg& svg, const PlanView& view, const plan::Edge& edge) {
  const Point a = view.centre(edge.a), b = view.centre(edge.b);
  const bool level = a.y == b.y;
  const Point low{std::min(a.x, b.x), std::min(a.y, b.y)};
  const double length = PlanView::cell - PlanView::strip;
  const Point corner{low.x + (level ? half : -half), low.y + (level ? -half : half)};
  const double width = level ? length : PlanView::strip, height = level ? PlanView::strip : length;
  svg.rectangle(corner, width, height, floor_fill(view.map().floors(), edge.floor));
  const Point across = level ? Point{0, height} : Point{width, 0};
  const Point along = level ? Point{width, 0} : Point{0, height};
  svg.line(corner, moved(corner, along, 1), wall_line);
  svg.line(moved(corner, across, 1), moved(moved(corner, across, 1), along, 1), wall_line);
}

void draw_tile(Svg& svg, const PlanView& view, std::uint32_t node) {
  const Point middle = view.centre(node);
  svg.rectangle({middle.x - half, middle.y - half}, PlanView::strip, PlanView::strip, tile_fill);
  for (const int heading : {0, 90, 180, 270}) {
    if (view.map().hallway(node, heading) != nullptr) continue;
    const Point wall = moved(middle, direction(heading), half), along = direction((heading + 90) % 360);
    svg.line(moved(wall, along, -half), moved(wall, along, half), wall_line);
  }
}

// On the north wall of level hallways, on the west wall of the others.
void draw_hanging(Svg& svg, const PlanView& view, const plan::Edge& edge) {
  const Point a = view.centre(edge.a), b = view.centre(edge.b);
  const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const Point place = a.y == b.y ? Point{middle.x, middle.y - half - 10} : Point{middle.x - half - 12, middle.y};
  draw_painting(svg, edge.wall, place, 14);
}

void draw_coordinates(Svg& svg, const PlanView& view) {
  constexpr std::string_view style = R"(fill="#8a8a8a" text-anchor="middle")";
  for (int x = view.min_x(); x <= view.max_x(); ++x) svg.text({view.centre(x, 0).x, 14}, 12, std::to_string(x), style);
  for (int y = view.min_y(); y <= view.max_y(); ++y)
    svg.text({10, view.centre(0, y).y + 4}, 12, std::to_string(y), style);
}

}  // namespace

void draw_map(Svg& svg, const PlanView& view) {
  const plan::Map& map = view.map();
  draw_coordinates(svg, view);
  for (const plan::Edge& edge : map.edges()) draw_hallway(svg, view, edge);
  for (std::uint32_t node = 0; node < map.nodes().size(); ++node) draw_tile(svg, view, node);
  for (const plan::Edge& edge : map.edges())
    if (!edge.wall.empty()) draw_hanging(svg, view, edge);
  for (std::uint32_t node = 0; node < map.nodes().size(); ++node)
    if (const auto& object = map.nodes()[node].object) draw_object(svg, *object, view.centre(node), 23);
}

void draw_place_badge(Svg& svg, Point centre, int place) {
  constexpr double size = 10;
  const std::string text = '#' + std::to_string(place);
  const double width = text_width(text) * size + 6;
  svg.rectangle({centre.x - width / 2, centre.y - 7}, width, 14, R"(fill="#20242b")");
  svg.text({centre.x, centre.y + 3.6}, size, text, R"(fill="#fff" text-anchor="middle" font-weight="bold")");
}

void draw_place_numbers(Svg& svg, PlanView& view) {
  for (std::uint32_t node = 0; node < view.map().nodes().size(); ++node)
    if (const auto place = view.map().nodes()[node].place)
      draw_place_badge(svg, view.corner(node, view.take_free(node)), *place);
}

void draw_compass(Svg& svg, Point centre) {
  svg.open("g", translated(centre));
  svg.path("M0 -22 L6 0 L0 -4 L-6 0 Z", R"(fill="#20242b")");
  svg.path("M0 22 L6 0 L0 4 L-6 0 Z", R"(fill="#fff" stroke="#20242b" stroke-width="1")");
  svg.text({0, -26}, 12, "N", R"(text-anchor="middle" font-weight="bold" fill="#20242b")");
  svg.close("g");
}

}  // namespace waymark::render
