#include "tools/render/motion_picture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "tools/render/route_picture.hpp"

namespace waymark::render {
namespace {

constexpr double least_body = 3;        // pixels: even a point can be seen moving
constexpr double seconds_per_unit = 1;  // of the animation

Point on_page(const PlanView& view, const plan::Configuration& c) { return view.centre(c.x, c.y); }

// Path data, relative to `origin`.
std::string path_of(const PlanView& view, const plan::Motion& motion, Point origin) {
  std::string d;
  for (const plan::Configuration& c : motion.configurations) {
    const Point p = on_page(view, c);
    d += (d.empty() ? "M" : " L") + at({p.x - origin.x, p.y - origin.y});
  }
  return d;
}

std::string stroke(std::string_view colour, double width, double opacity) {
  return R"(fill="none" stroke-linecap="round" stroke-linejoin="round" stroke=")" + std::string(colour) +
         "\" stroke-width=\"" + number(width) + "\" stroke-opacity=\"" + number(opacity) + '"';
}

// The robot where it starts; viewers that do not animate leave it under the start mark.
void draw_robot(Svg& svg, const PlanView& view, const plan::Motion& motion) {
  const Point start = on_page(view, motion.configurations.front());
  const double radius = std::max(least_body, motion.radius * PlanView::cell);
  svg.open("circle", "cx=\"" + number(start.x) + "\" cy=\"" + number(start.y) + "\" r=\"" + number(radius) +
                         "\" fill=\"" + std::string(start_colour) + R"(" stroke="#fff" stroke-width="1")");
  svg.open("animateMotion", "repeatCount=\"indefinite\" dur=\"" +
                                number(std::max(1.0, seconds_per_unit * plan::length(motion))) +
                                "s\" path=\"" + path_of(view, motion, start) + '"');
  svg.close("animateMotion");
  svg.close("circle");
}

}  // namespace

void draw_motion(Svg& svg, const PlanView& view, const plan::Motion& motion) {
  if (motion.configurations.empty()) return;
  const std::string d = path_of(view, motion, {0, 0});
  svg.path(d, stroke(route_colour, 2 * motion.radius * PlanView::cell, 0.22));
  svg.path(d, stroke("#fff", 5, 0.9));
  svg.path(d, stroke(route_colour, 2.6, 1));
  const plan::Configuration &first = motion.configurations.front(), &last = motion.configurations.back();
  draw_robot(svg, view, motion);
  const auto quarter = [](double heading) { return static_cast<int>(std::lround(heading / 90) % 4 * 90); };
  draw_end_mark(svg, on_page(view, last), quarter(last.heading));
  if (plan::distance(position(first), position(last)) > 0)
    draw_start_mark(svg, on_page(view, first), quarter(first.heading));
}

}  // namespace waymark::render
