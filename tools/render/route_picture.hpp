// A route drawn on the map: a line that keeps to the right of the hallway, so that there and back can be told apart
// and furniture stays visible; turns are arcs around the place; every action has its number.
#pragma once
#include "libplan/world/trajectory.hpp"
#include "tools/render/plan_view.hpp"

namespace waymark::render {

// Takes the corners of the view that its numbers stand in.
void draw_route(Svg& svg, PlanView& view, const plan::Trajectory& route);

inline constexpr std::string_view route_colour = "#b0002a";
inline constexpr std::string_view start_colour = "#00664f";
void draw_start_mark(Svg& svg, Point where, int heading);
void draw_step_number(Svg& svg, Point centre, std::string_view text);
void draw_end_mark(Svg& svg, Point where, int heading);

}  // namespace waymark::render
