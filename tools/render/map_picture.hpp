// The map as one would draw it on paper: hallways with their floors, paintings on the walls, furniture at the places.
#pragma once
#include "tools/render/plan_view.hpp"

namespace waymark::render {

void draw_map(Svg& svg, const PlanView& view);
// Number badges of the places, at corners that are still free: after the route has taken its own.
void draw_place_numbers(Svg& svg, PlanView& view);
void draw_compass(Svg& svg, Point centre);
void draw_place_badge(Svg& svg, Point centre, int place);

}  // namespace waymark::render
