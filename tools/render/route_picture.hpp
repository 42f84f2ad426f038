// A route drawn on the map: a line that keeps to the right of the hallway, so that there and back can be told apart
// and furniture stays visible; turns are arcs around the place; every action has its number.
#pragma once
#include "libplan/world/trajectory.hpp"
#include "tools/render/plan_view.hpp"

namespace waymark::render {

// The last `repeated` actions are a cycle, walked for ever: the cycle has a colour of its own, what leads there is
// dashed, and a ring stands where the cycle begins. Takes the corners of the view that the numbers of actions stand in.
void draw_route(Svg& svg, PlanView& view, const plan::Trajectory& route, std::size_t repeated = 0);

inline constexpr std::string_view route_colour = "#b0002a";
inline constexpr std::string_view cycle_colour = "#0058a8";
inline constexpr std::string_view start_colour = "#00664f";
void draw_start_mark(Svg& svg, Point where, int heading);
void draw_step_number(Svg& svg, Point centre, std::string_view text, std::string_view colour = route_colour);
void draw_end_mark(Svg& svg, Point where, int heading);
void draw_cycle_mark(Svg& svg, Point where);  // a ring around what stands there

}  // namespace waymark::render
