#include "tools/render/value_picture.hpp"

#include <algorithm>
#include <cmath>

#include "tools/render/floors.hpp"
#include "tools/render/map_picture.hpp"
#include "tools/render/page.hpp"

namespace waymark::render {
namespace {

constexpr double outer = PlanView::strip / 2, inner = 12, border = 28, title = 58;

// From white to a dark blue by lightness alone: the order is kept in grey and for every kind of colour vision.
std::string shade(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  const auto channel = [&](double dark) { return std::to_string(std::lround(255 - t * (255 - dark))); };
  return "rgb(" + channel(8) + ',' + channel(58) + ',' + channel(120) + ')';
}

void draw_mark(Svg& svg, const PlanView& view, const PoseMark& mark) {
  const plan::Map& map = view.map();
  const int heading = map.pose(mark.pose).heading;
  const Point centre = view.centre(map.node_of(mark.pose));
  const std::string ink = mark.share > 0.5 ? "#fff" : "#20242b";
  svg.open("g", translated(centre));
  svg.open("g", "transform=\"rotate(" + std::to_string(heading) + ")\"");
  svg.path("M " + at({-outer, -outer}) + " L " + at({outer, -outer}) + " L " + at({inner, -inner}) + " L " +
               at({-inner, -inner}) + " Z",
           "fill=\"" + shade(mark.share) + R"(" stroke="#20242b" stroke-width="0.6")");
  const double middle = -(outer + inner) / 2;
  if (mark.action) {
    constexpr std::string_view forward = "M0 4.5 L0 -4.5 M-3 -1.5 L0 -4.5 L3 -1.5";
    constexpr std::string_view left = "M3 4.5 L3 -1 L-4.5 -1 M-1.5 -4 L-4.5 -1 L-1.5 2";
    constexpr std::string_view right = "M-3 4.5 L-3 -1 L4.5 -1 M1.5 -4 L4.5 -1 L1.5 2";
    svg.open("g", translated({0, middle}));
    svg.path(
        *mark.action == plan::Action::Forward ? forward
        : *mark.action == plan::Action::Left  ? left
                                              : right,
        "fill=\"none\" stroke=\"" + ink + R"(" stroke-width="1.7" stroke-linejoin="round" stroke-linecap="round")");
    svg.close("g");
  } else if (!mark.value.empty()) {  // upright: the text of the south field is turned back
    svg.open("g", translated({0, middle}));
    const double size = std::min(9.0, 2 * (outer + inner) * 0.46 / std::max(1.0, text_width(mark.value)));
    svg.text({0, 3.2}, size, mark.value,
             "text-anchor=\"middle\" fill=\"" + ink + '"' + (heading == 180 ? " transform=\"rotate(180)\"" : ""));
    svg.close("g");
  }
  svg.close("g");
  svg.close("g");
}

}  // namespace

std::string draw_values(const ValuePage& page) {
  const PlanView view(*page.map);
  const double width = 2 * border + view.width();
  Svg svg;
  open_document(svg, width, 2 * border + title + view.height());
  svg.open("defs");
  define_floors(svg, page.map->floors());
  svg.close("defs");
  svg.text({border, border + 14}, 16, drawable(page.formula), R"(fill="#1c3f7c")");
  double y = border + 36;
  for (const std::string& line : wrapped(page.caption, (width - 2 * border) / 13)) {
    svg.text({border, y}, 13, line, R"(fill="#5c5c5c")");
    y += 17;
  }
  svg.open("g", translated({border, border + title}));
  draw_map(svg, view);
  for (const PoseMark& mark : page.marks) draw_mark(svg, view, mark);
  svg.close("g");
  svg.close("svg");
  return svg.str();
}

}  // namespace waymark::render
