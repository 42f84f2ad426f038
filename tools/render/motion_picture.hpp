// A motion drawn in its workspace: the line of the robot's centre, the band that a disc sweeps, and for viewers that
// animate the robot going along it, its body to scale, with the trail behind it.
#pragma once
#include <cstdint>

#include "libplan/motion/motion.hpp"
#include "tools/render/automaton_picture.hpp"
#include "tools/render/svg.hpp"

namespace waymark::render {

struct Scale {  // from the workspace to the page
  Point origin;
  double unit = 1;
  Point operator()(double x, double y) const { return {origin.x + unit * x, origin.y + unit * y}; }
};

void draw_motion(Svg& svg, const Scale& scale, const plan::Motion& motion);

struct Visit {              // the automaton is in that state
  std::uint32_t state = 0;  // as in the title of its node
  double time = 0;          // from then on, a time of the motion, until the next visit
};
// The states of the automaton light up while the motion is in them.
void light_up(Drawing& automaton, const plan::Motion& motion, const std::vector<Visit>& visits);

}  // namespace waymark::render
