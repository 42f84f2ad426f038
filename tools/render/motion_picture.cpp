#include "tools/render/motion_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tools/render/playback.hpp"
#include "tools/render/route_picture.hpp"

namespace waymark::render {
namespace {

constexpr double least_body = 3;  // pixels: even a point can be seen moving
constexpr std::string_view lit = "#ffd166";

std::string path_of(const Scale& scale, const Playback& playback) {
  std::string d;
  for (const Frame& frame : playback.frames()) d += (d.empty() ? "M" : " L") + at(scale(frame.at.x, frame.at.y));
  return d;
}

std::string stroke(std::string_view colour, double width, double opacity) {
  return R"(fill="none" stroke-linecap="round" stroke-linejoin="round" stroke=")" + std::string(colour) +
         "\" stroke-width=\"" + number(width) + "\" stroke-opacity=\"" + number(opacity) + '"';
}

void animate(Svg& svg, std::string_view element, const std::string& attributes) {
  svg.open(element, attributes);
  svg.close(element);
}

// The line behind the robot; viewers that do not animate show all of it.
void draw_trail(Svg& svg, const Scale& scale, const Playback& playback, std::string_view d) {
  const double whole = playback.frames().back().travelled * scale.unit;
  const std::string dash = number(whole + 1);
  svg.open("path", "d=\"" + std::string(d) + "\" " + stroke(route_colour, 2.6, 1) + " stroke-dasharray=\"" + dash +
                       ' ' + dash + '"');
  if (whole > 0)
    animate(svg, "animate", playback.moving("stroke-dashoffset", [&](const Frame& frame) {
      return number(whole + 1 - frame.travelled * scale.unit);
    }));
  svg.close("path");
}

std::string outline_of(const plan::Car& car, double unit) {  // headed north, at the origin
  std::string d;
  for (const plan::Point& corner : plan::body(car, {}))
    d += (d.empty() ? "M" : " L") + at({corner.x * unit, corner.y * unit});
  return d + " Z";
}

// The body at the origin, headed north: a disc with a nose, a car with a windscreen.
void draw_body(Svg& svg, const plan::Robot& robot, double unit) {
  const std::string paint = "fill=\"" + std::string(start_colour) + R"(" stroke="#fff" stroke-width="0.8")";
  constexpr std::string_view mark = R"(fill="none" stroke="#fff" stroke-width="1.2")";
  if (const auto* disc = std::get_if<plan::Disc>(&robot)) {
    const double radius = std::max(least_body, disc->radius * unit);
    svg.circle({0, 0}, radius, paint);
    svg.line({0, 0}, {0, -radius}, mark);
    return;
  }
  const auto& car = std::get<plan::Car>(robot);
  svg.path(outline_of(car, unit), paint);
  const double screen = -0.45 * car.length * unit, side = 0.32 * car.width * unit;
  svg.line({-side, screen}, {side, screen}, mark);
}

// Viewers that do not animate leave it where it starts.
void draw_robot(Svg& svg, const Scale& scale, const plan::Robot& robot, const Playback& playback) {
  const Frame& start = playback.frames().front();
  const auto place = [&](const Frame& frame) {
    const Point p = scale(frame.at.x, frame.at.y);
    return number(p.x) + ',' + number(p.y);
  };
  const auto heading = [&](const Frame& frame) { return number(start.at.heading + frame.turned); };
  svg.open("g", "transform=\"translate(" + place(start) + ")\"");
  animate(svg, "animateTransform", "type=\"translate\" " + playback.moving("transform", place));
  svg.open("g", "transform=\"rotate(" + heading(start) + ")\"");
  animate(svg, "animateTransform", "type=\"rotate\" " + playback.moving("transform", heading));
  draw_body(svg, robot, scale.unit);
  svg.close("g");
  svg.close("g");
}

// A lit copy of the outline of the state's node, under it; nothing where the automaton is drawn without that state.
void add_light(std::string& drawing, std::uint32_t state, const std::string& animation) {
  constexpr std::string_view unfilled = "fill=\"none\"";
  const auto title = drawing.find("<title>" + std::to_string(state) + "</title>");
  const auto node = title == std::string::npos ? title : drawing.find("<ellipse", title);
  const auto end = node == std::string::npos ? node : drawing.find("/>", node);
  if (end == std::string::npos) return;
  std::string light = drawing.substr(node, end - node);
  const auto fill = light.find(unfilled);
  if (fill == std::string::npos) return;
  light.replace(fill, unfilled.size(), "fill=\"" + std::string(lit) + "\" opacity=\"0\"");
  drawing.insert(node, light + "><animate " + animation + "/></ellipse>\n");
}

}  // namespace

void draw_motion(Svg& svg, const Scale& scale, const plan::Motion& motion) {
  if (motion.configurations.empty()) return;
  const Playback playback(motion);
  const std::string d = path_of(scale, playback);
  if (const auto* disc = std::get_if<plan::Disc>(&motion.robot))
    svg.path(d, stroke(route_colour, 2 * disc->radius * scale.unit, 0.22));
  svg.path(d, stroke("#fff", 5, 0.9));
  svg.path(d, stroke(route_colour, 2.6, 0.3));
  draw_trail(svg, scale, playback, d);
  const plan::Configuration& last = motion.configurations.back();
  const auto quarter = [](double heading) { return static_cast<int>(std::lround(heading / 90) % 4 * 90); };
  draw_end_mark(svg, scale(last.x, last.y), quarter(last.heading));
  draw_robot(svg, scale, motion.robot, playback);
}

void light_up(Drawing& automaton, const plan::Motion& motion, const std::vector<Visit>& visits) {
  const Playback playback(motion);
  std::map<std::uint32_t, std::vector<Playback::Span>> lights;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const double to = i + 1 < visits.size() ? visits[i + 1].time : playback.frames().back().time;
    std::vector<Playback::Span>& spans = lights[visits[i].state];
    if (!spans.empty() && spans.back().to == visits[i].time)
      spans.back().to = to;
    else
      spans.push_back({visits[i].time, to});
  }
  for (const auto& [state, spans] : lights)
    add_light(automaton.content, state, playback.switched("opacity", spans, "0.8", "0"));
}

}  // namespace waymark::render
