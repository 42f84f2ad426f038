#include "tools/render/cost_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/render/svg.hpp"

namespace waymark::render {
namespace {

constexpr double panel_width = 300, height = 430, left = 62, top = 84, bottom = 56, gap = 24, legend = 190;
// Colours that people with any kind of colour vision tell apart (Okabe and Ito).
constexpr std::array<std::string_view, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#5c5c5c", "#a08c00"};

struct Range {  // of one axis, decimal logarithms
  double from, to;
  double share(double value) const { return (std::log10(value) - from) / (to - from); }
};

Range decades(const CostPlot& plot) {
  double least = 1e300, most = 1e-300;
  for (const CostPanel& panel : plot.panels)
    for (const auto& line : panel.costs)
      for (const double cost : line) least = std::min(least, cost), most = std::max(most, cost);
  return {std::floor(std::log10(least)), std::ceil(std::log10(most))};
}

class Panel {
 public:
  Panel(Svg& svg, const CostPanel& panel, double x0, const Range& y)
      : svg_(svg), panel_(panel), x0_(x0), x_{std::log10(panel.sizes.front()), std::log10(panel.sizes.back())}, y_(y) {
    if (x_.to <= x_.from) x_.to = x_.from + 1;
  }

  void draw_axes(bool labelled) const {
    for (double decade = y_.from; decade <= y_.to; ++decade) {
      const double y = y_of(std::pow(10, decade));
      svg_.line({x0_, y}, {x0_ + panel_width, y}, R"(stroke="#dcdcdc" stroke-width="1")");
      if (labelled)
        svg_.text({x0_ - 8, y + 4}, 12, decade < -2 ? "1e" + number(decade) : number(std::pow(10, decade)),
                  R"(text-anchor="end" fill="#5c5c5c")");
    }
    for (const double size : panel_.sizes) {
      svg_.line({x_of(size), height - bottom}, {x_of(size), height - bottom + 5},
                R"(stroke="#5c5c5c" stroke-width="1")");
      svg_.text({x_of(size), height - bottom + 20}, 12, number(size), R"(text-anchor="middle" fill="#5c5c5c")");
    }
    svg_.text({x0_ + panel_width / 2, height - 14}, 13, panel_.over, R"(text-anchor="middle" fill="#20242b")");
  }

  void draw_lines() const {
    for (std::size_t i = 0; i < panel_.costs.size(); ++i) {
      std::string d;
      for (std::size_t k = 0; k < panel_.sizes.size(); ++k)
        d += (d.empty() ? "M " : " L ") + at({x_of(panel_.sizes[k]), y_of(panel_.costs[i][k])});
      svg_.path(d, R"(fill="none" stroke-width="2" stroke=")" + std::string(colours[i]) + '"');
    }
  }

 private:
  double x_of(double size) const { return x0_ + 14 + (panel_width - 28) * x_.share(size); }
  double y_of(double cost) const { return height - bottom - (height - top - bottom) * y_.share(cost); }

  Svg& svg_;
  const CostPanel& panel_;
  double x0_;
  Range x_, y_;
};

}  // namespace

std::string draw_costs(const CostPlot& plot) {
  const double after = left + static_cast<double>(plot.panels.size()) * (panel_width + gap), width = after + legend;
  const Range y = decades(plot);
  Svg svg;
  svg.open_picture(width, height);
  svg.text({16, 24}, 16, plot.title, R"(fill="#1c3f7c")");
  svg.text({16, 44}, 13, plot.caption, R"(fill="#5c5c5c")");
  svg.text({16, top - 14}, 13, plot.unit, R"(fill="#20242b")");
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const Panel panel(svg, plot.panels[i], left + static_cast<double>(i) * (panel_width + gap), y);
    panel.draw_axes(i == 0);
    panel.draw_lines();
  }
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const double row = top + 10 + 22 * static_cast<double>(i);
    svg.path("M " + at({after, row}) + " L " + at({after + 26, row}),
             R"(fill="none" stroke-width="2" stroke=")" + std::string(colours[i]) + '"');
    svg.text({after + 34, row + 4}, 13, plot.lines[i], R"(fill="#20242b")");
  }
  svg.close("svg");
  return svg.str();
}

}  // namespace waymark::render
