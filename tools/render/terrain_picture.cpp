#include "tools/render/terrain_picture.hpp"

#include <algorithm>
#include <array>

#include "tools/render/page.hpp"

namespace waymark::render {
namespace {

constexpr double border = 28, gutter = 34, longest_side = 720, panel = 400, title = 70;
constexpr std::array<std::string_view, 6> colours{"#bcd9f0", "#f6d7a7", "#cfe8c4", "#e8c7dd", "#d8d2f0", "#f3c6bd"};

std::string outline(const plan::Polygon& polygon, const Scale& scale) {
  std::string d;
  for (const plan::Point& p : polygon) d += (d.empty() ? "M" : " L") + at(scale(p.x, p.y));
  return d + " Z";
}

Point middle_of(const plan::Polygon& polygon, const Scale& scale) {
  plan::Point sum;
  for (const plan::Point& p : polygon) sum = {sum.x + p.x, sum.y + p.y};
  const auto n = static_cast<double>(polygon.size());
  return scale(sum.x / n, sum.y / n);
}

void draw_terrain(Svg& svg, const plan::Terrain& terrain, const Scale& scale) {
  svg.path(outline(terrain.border(), scale), R"(fill="#fbfaf7" stroke="#2b2b2b" stroke-width="2.2")");
  for (const plan::NamedRegion& region : terrain.regions()) {
    const auto index = terrain.vocabulary().find(region.name).value().index;
    svg.path(outline(region.border, scale),
             "fill=\"" + std::string(colours.at(index % colours.size())) +
                 R"(" fill-opacity="0.6" stroke="#7a7a7a" stroke-width="0.8" stroke-dasharray="4 3")");
  }
  for (const plan::Polygon& obstacle : terrain.obstacles())
    svg.path(outline(obstacle, scale), R"(fill="#6b6b6b" stroke="#2b2b2b" stroke-width="1.6")");
  for (const plan::NamedRegion& region : terrain.regions())
    svg.text(middle_of(region.border, scale), 13, region.name, R"(text-anchor="middle" fill="#3a3a3a")");
}

}  // namespace

std::string draw_page(const TerrainPage& page) {
  const plan::Terrain& terrain = *page.terrain;
  const double wide = terrain.high().x - terrain.low().x, tall = terrain.high().y - terrain.low().y;
  const double unit = longest_side / std::max(wide, tall);
  const double beside = page.automaton ? gutter + panel : 0;
  const double width = 2 * border + unit * wide + beside;
  const double height = 2 * border + title + std::max(unit * tall, page.automaton ? 400.0 : 0.0);
  const Scale scale{{border - unit * terrain.low().x, border + title - unit * terrain.low().y}, unit};
  Svg svg;
  open_document(svg, width, height);
  svg.text({border, border + 14}, 16, drawable(page.formula), R"(fill="#1c3f7c")");
  svg.text({border, border + 38}, 13, page.caption, R"(fill="#5c5c5c")");
  draw_terrain(svg, terrain, scale);
  if (page.motion) draw_motion(svg, scale, page.motion->motion());
  if (page.automaton)
    embed(svg, *page.automaton, {border + unit * wide + gutter, border + title}, panel, height - 2 * border - title);
  svg.close("svg");
  return svg.str();
}

}  // namespace waymark::render
