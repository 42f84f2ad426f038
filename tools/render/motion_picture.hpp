// A motion drawn on the map: the line of the robot's centre, the band that its body sweeps, and the robot itself going
// along it, for viewers that animate.
#pragma once
#include "libplan/motion/motion.hpp"
#include "tools/render/plan_view.hpp"

namespace waymark::render {

void draw_motion(Svg& svg, const PlanView& view, const plan::Motion& motion);

}  // namespace waymark::render
