#include "tools/render/route_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace waymark::render {
namespace {

constexpr double lane = 16.5;  // distance of the line from the middle of the hallway

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
double length(Point a) { return std::hypot(a.x, a.y); }
Point right_of(int heading) { return direction((heading + 90) % 360); }
bool is_turn(plan::Action action) { return action != plan::Action::Forward; }

// Where a walker in this pose is drawn.
Point lane_point(const PlanView& view, plan::PoseId pose) {
  return view.centre(view.map().node_of(pose)) + lane * right_of(view.map().pose(pose).heading);
}

// A way through points with rounded corners.
class Way {
 public:
  void go_to(Point p) {
    if (points_.empty() || length(points_.back() - p) > 0.01) points_.push_back(p);
  }
  // Corners are rounded by `radius`, less where the legs are short.
  std::string path(double radius) const {
    std::string d = "M" + at(points_.front());
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (i + 1 == points_.size()) return d + " L" + at(points_[i]);
      const Point in = points_[i] - points_[i - 1], out = points_[i + 1] - points_[i];
      const double r = std::min({radius, length(in) / 2, length(out) / 2});
      d += " L" + at(points_[i] - (r / length(in)) * in) + " Q" + at(points_[i]) + ' ' +
           at(points_[i] + (r / length(out)) * out);
    }
    return d;
  }

 private:
  std::vector<Point> points_;
};

// Where the two lanes meet when a walker heading `from` turns once: for a left turn beyond the middle of the place,
// for a right turn before it.
Point turn_point(const PlanView& view, std::uint32_t node, int from, plan::Action turn) {
  const double ahead = turn == plan::Action::Left ? lane : -lane;
  return view.centre(node) + lane * right_of(from) + ahead * direction(from);
}

Corner turn_corner(int from, plan::Action turn) {
  const int side = turn == plan::Action::Left ? from : (from + 90) % 360;  // north: NE for a left turn, SE for a right
  switch (side) {
    case 0: return Corner::NorthEast;
    case 90: return Corner::SouthEast;
    case 180: return Corner::SouthWest;
    default: return Corner::NorthWest;
  }
}

Way way_of(const PlanView& view, const plan::Trajectory& route) {
  Way way;
  way.go_to(lane_point(view, route.poses.front()));
  for (std::size_t i = 0; i < route.actions.size(); ++i) {
    const plan::PoseId pose = route.poses[i];
    if (is_turn(route.actions[i]))
      way.go_to(turn_point(view, view.map().node_of(pose), view.map().pose(pose).heading, route.actions[i]));
    const bool goes_straight_on = !is_turn(route.actions[i]) && i + 1 < route.actions.size();
    const bool turns_next = is_turn(route.actions[i]) && i + 1 < route.actions.size();
    if (!goes_straight_on && !turns_next) way.go_to(lane_point(view, route.poses[i + 1]));
  }
  return way;
}

// Numbers of actions, gathered by where they are written, so that a place passed twice shows "3, 9".
class StepNumbers {
 public:
  StepNumbers(PlanView& view, const plan::Trajectory& route, std::size_t repeated) {
    for (std::size_t i = 0; i < route.actions.size(); ++i) {
      const auto colour = i + repeated < route.actions.size() ? route_colour : cycle_colour;
      const plan::PoseId from = route.poses[i];
      const std::uint32_t node = view.map().node_of(from);
      if (is_turn(route.actions[i])) {
        const Corner corner = turn_corner(view.map().pose(from).heading, route.actions[i]);
        view.take(node, corner);
        add(view.corner(node, corner), i + 1, colour);
      } else {
        add(0.5 * (lane_point(view, from) + lane_point(view, route.poses[i + 1])), i + 1, colour);
      }
    }
  }
  void draw(Svg& svg) const {
    for (const auto& [key, label] : labels_) draw_step_number(svg, label.where, label.text, label.colour);
  }

 private:
  struct Label {
    Point where;
    std::string text;
    std::string_view colour;
  };
  void add(Point where, std::size_t step, std::string_view colour) {
    Label& label = labels_[{std::lround(where.x), std::lround(where.y)}];
    label.where = where;
    label.colour = colour;
    label.text += (label.text.empty() ? "" : ", ") + std::to_string(step);
  }
  std::map<std::pair<long, long>, Label> labels_;
};

// A small arrow head after the number of each move.
void draw_arrow_heads(Svg& svg, const PlanView& view, const plan::Trajectory& route, std::string_view colour) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;
  for (std::size_t i = 0; i < route.actions.size(); ++i) {
    if (is_turn(route.actions[i]) || !drawn.emplace(route.poses[i].index, route.poses[i + 1].index).second) continue;
    const int heading = view.map().pose(route.poses[i]).heading;
    const Point from = lane_point(view, route.poses[i]), to = lane_point(view, route.poses[i + 1]);
    const Point tip = from + 0.72 * (to - from), back = tip - 9 * direction(heading);
    const Point side = 5.5 * right_of(heading);
    svg.path("M" + at(tip) + " L" + at(back + side) + " L" + at(back - side) + " Z",
             "fill=\"" + std::string(colour) + R"(" stroke="#fff" stroke-width="1.2" stroke-linejoin="round")");
  }
}

void draw_line(Svg& svg, const PlanView& view, const plan::Trajectory& walk, std::string_view colour,
               const std::string& dashes) {
  if (walk.actions.empty()) return;
  const std::string d = way_of(view, walk).path(lane);
  const std::string common = R"(fill="none" stroke-linecap="round" stroke-linejoin="round" stroke=)";
  svg.path(d, common + R"("#fff" stroke-width="7" stroke-opacity="0.9")");
  svg.path(d, common + '"' + std::string(colour) + "\" stroke-width=\"3.6\"" + dashes);
}

// The actions from `begin` to before `end`.
plan::Trajectory part(const plan::Trajectory& route, std::size_t begin, std::size_t end) {
  const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  return {{route.poses.begin() + at(begin), route.poses.begin() + at(end) + 1},
          {route.actions.begin() + at(begin), route.actions.begin() + at(end)}};
}

}  // namespace

void draw_start_mark(Svg& svg, Point where, int heading) {
  svg.circle(where, 8, "fill=\"" + std::string(start_colour) + R"(" stroke="#fff" stroke-width="1.6")");
  const Point tip = where + 5.4 * direction(heading), back = where - 3.2 * direction(heading);
  const Point side = 4 * right_of(heading);
  svg.path("M" + at(tip) + " L" + at(back + side) + " L" + at(back - side) + " Z", R"(fill="#fff")");
}

void draw_step_number(Svg& svg, Point centre, std::string_view text, std::string_view colour) {
  constexpr double size = 11;
  const double width = std::max(15.0, text_width(text) * size + 7);
  svg.rectangle({centre.x - width / 2, centre.y - 7.5}, width, 15,
                R"(rx="7.5" fill="#fff" stroke-width="1.3" stroke=")" + std::string(colour) + '"');
  svg.text({centre.x, centre.y + 3.9}, size, text, R"(text-anchor="middle" fill="#20242b")");
}

void draw_end_mark(Svg& svg, Point where, int heading) {
  const std::string colour(route_colour);
  svg.circle(where, 7.6, "fill=\"#fff\" stroke=\"" + colour + "\" stroke-width=\"2.4\"");
  const Point tip = where + 5 * direction(heading), back = where - 3.2 * direction(heading);
  const Point side = 3.9 * right_of(heading);
  svg.path("M" + at(tip) + " L" + at(back + side) + " L" + at(back - side) + " Z", "fill=\"" + colour + '"');
}

void draw_cycle_mark(Svg& svg, Point where) {
  svg.circle(where, 11.5, R"(fill="none" stroke="#fff" stroke-width="5")");
  svg.circle(where, 11.5, "fill=\"none\" stroke=\"" + std::string(cycle_colour) + R"(" stroke-width="2.8")");
}

void draw_route(Svg& svg, PlanView& view, const plan::Trajectory& route, std::size_t repeated) {
  const std::size_t actions = route.actions.size(), split = actions - repeated;
  const plan::Trajectory prefix = part(route, 0, split), cycle = part(route, split, actions);
  draw_line(svg, view, prefix, route_colour, repeated == 0 ? "" : R"( stroke-dasharray="7 6")");
  draw_line(svg, view, cycle, cycle_colour, "");
  draw_arrow_heads(svg, view, prefix, route_colour);
  draw_arrow_heads(svg, view, cycle, cycle_colour);
  const StepNumbers numbers(view, route, repeated);
  numbers.draw(svg);
  const auto heading = [&](plan::PoseId pose) { return view.map().pose(pose).heading; };
  const plan::PoseId first = route.poses.front(), last = route.poses.back();
  if (repeated == 0)
    draw_end_mark(svg, lane_point(view, last), heading(last));
  else
    draw_cycle_mark(svg, lane_point(view, route.poses[split]));
  if (first != last || repeated > 0) draw_start_mark(svg, lane_point(view, first), heading(first));
}

}  // namespace waymark::render
