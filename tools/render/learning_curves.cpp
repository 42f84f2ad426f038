#include "tools/render/learning_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "tools/render/svg.hpp"

namespace waymark::render {
namespace {

constexpr double width = 860, height = 470, left = 58, right = 210, top = 90, bottom = 52;
// Colours that people with any kind of colour vision tell apart (Okabe and Ito), then the same dashed.
constexpr std::array<std::string_view, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#5c5c5c", "#a08c00"};

struct Axes {
  double most_steps;
  double x(double steps) const { return left + (width - left - right) * steps / most_steps; }
  static double y(double value) { return height - bottom - (height - top - bottom) * value; }
};

// 1, 2 or 5 times a power of ten, so that the axis has four to ten of them.
double tick(double most) {
  const double power = std::pow(10, std::floor(std::log10(most / 4)));
  for (const double factor : {5.0, 2.0})
    if (most / (factor * power) >= 4) return factor * power;
  return power;
}

void draw_axes(Svg& svg, const Axes& axes) {
  for (int i = 0; i <= 5; ++i) {
    const double value = i / 5.0, y = Axes::y(value);
    svg.line({left, y}, {width - right, y}, R"(stroke="#dcdcdc" stroke-width="1")");
    svg.text({left - 8, y + 4}, 12, number(value), R"(text-anchor="end" fill="#5c5c5c")");
  }
  const double step = tick(axes.most_steps);
  for (double at = 0; at <= axes.most_steps * (1 + 1e-9); at += step) {
    svg.line({axes.x(at), Axes::y(0)}, {axes.x(at), Axes::y(0) + 5}, R"(stroke="#5c5c5c" stroke-width="1")");
    svg.text({axes.x(at), Axes::y(0) + 20}, 12, number(at), R"(text-anchor="middle" fill="#5c5c5c")");
  }
  svg.text({(left + width - right) / 2, height - 12}, 13, "environment steps",
           R"(text-anchor="middle" fill="#20242b")");
  svg.text({left - 42, top - 14}, 13, "score of the policy (1: an optimal route)", R"(fill="#20242b")");
}

std::string line_of(const Curve& curve, const Axes& axes) {
  std::string d;
  for (const Curve::Point& p : curve.points) d += (d.empty() ? "M " : " L ") + at({axes.x(p.steps), Axes::y(p.value)});
  return d;
}

std::string band_of(const Curve& curve, const Axes& axes) {
  std::string d;
  for (const Curve::Point& p : curve.points) d += (d.empty() ? "M " : " L ") + at({axes.x(p.steps), Axes::y(p.high)});
  for (auto p = curve.points.rbegin(); p != curve.points.rend(); ++p)
    d += " L " + at({axes.x(p->steps), Axes::y(p->low)});
  return d + " Z";
}

// Circle, square, triangle, diamond; filled, then hollow.
void draw_mark(Svg& svg, Point at, std::size_t i, const std::string& colour) {
  const bool filled = i % 8 < 4;
  const std::string style = "stroke=\"" + colour + "\" stroke-width=\"1.6\" fill=\"" + (filled ? colour : "#fff") + '"';
  const auto shape = [&](std::initializer_list<Point> corners) {
    std::string d;
    for (const Point corner : corners) d += (d.empty() ? "M " : " L ") + render::at({at.x + corner.x, at.y + corner.y});
    svg.path(d + " Z", style);
  };
  switch (i % 4) {
    case 0: svg.circle(at, 4, style); break;
    case 1: shape({{-3.6, -3.6}, {3.6, -3.6}, {3.6, 3.6}, {-3.6, 3.6}}); break;
    case 2: shape({{0, -4.6}, {4.4, 3.4}, {-4.4, 3.4}}); break;
    default: shape({{0, -5}, {5, 0}, {0, 5}, {-5, 0}}); break;
  }
}

double legend_y(std::size_t row) { return top + 10 + 22 * static_cast<double>(row); }

void draw_legend_name(Svg& svg, std::size_t row, const std::string& name) {
  svg.text({width - right + 50, legend_y(row) + 4}, 13, name, R"(fill="#20242b")");
}

void draw_curve(Svg& svg, const Curve& curve, std::size_t i, std::size_t curves, std::size_t row, const Axes& axes) {
  const std::string colour(colours[i % colours.size()]);
  const std::string stroke = R"(fill="none" stroke-width="2" stroke=")" + colour + '"' +
                             (i < colours.size() ? "" : R"( stroke-dasharray="6 4")");
  svg.path(band_of(curve, axes), R"(fill-opacity="0.15" stroke="none" fill=")" + colour + '"');
  svg.path(line_of(curve, axes), stroke);
  constexpr std::size_t marks = 8;  // on each curve, about
  const std::size_t stride = std::max<std::size_t>(1, curve.points.size() / marks);
  for (std::size_t k = stride * i / std::max<std::size_t>(1, curves); k < curve.points.size(); k += stride)
    draw_mark(svg, {axes.x(curve.points[k].steps), Axes::y(curve.points[k].value)}, i, colour);
  const double y = legend_y(row);
  svg.path("M " + at({width - right + 16, y}) + " L " + at({width - right + 42, y}), stroke);
  draw_mark(svg, {width - right + 29, y}, i, colour);
  draw_legend_name(svg, row, curve.name);
}

void draw_exact(Svg& svg, const std::vector<std::string>& names, const Axes& axes) {
  constexpr std::string_view stroke = R"(stroke="#20242b" stroke-width="2" stroke-dasharray="2 4" fill="none")";
  svg.path("M " + at({axes.x(0), Axes::y(1)}) + " L " + at({axes.x(axes.most_steps), Axes::y(1)}), stroke);
  for (std::size_t row = 0; row < names.size(); ++row) {
    const double y = legend_y(row);
    svg.path("M " + at({width - right + 16, y}) + " L " + at({width - right + 42, y}), stroke);
    draw_legend_name(svg, row, names[row] + " (exact)");
  }
}

}  // namespace

std::string draw_curves(const CurvePlot& plot) {
  Axes axes{1};
  for (const Curve& curve : plot.curves)
    for (const Curve::Point& p : curve.points) axes.most_steps = std::max(axes.most_steps, p.steps);
  Svg svg;
  svg.open_picture(width, height);
  svg.text({16, 24}, 16, plot.title, R"(fill="#1c3f7c")");
  svg.text({16, 44}, 13, plot.caption, R"(fill="#5c5c5c")");
  draw_axes(svg, axes);
  const std::size_t exact = plot.exact.size(), learners = plot.curves.size();
  for (std::size_t i = 0; i < learners; ++i) draw_curve(svg, plot.curves[i], i, learners, exact + i, axes);
  if (exact > 0) draw_exact(svg, plot.exact, axes);
  svg.close("svg");
  return svg.str();
}

}  // namespace waymark::render
