// Motions from JSON: {"motion":[[x,y,heading],…],"radius":r}, as `waymark move --json` answers; of a car, "car" with
// "length", "width" and "turning_radius" replaces the radius. Other keys are ignored. route_of and certify check the
// motion.
#pragma once
#include <string_view>

#include "libplan/motion/motion.hpp"

namespace waymark::plan {

// Throws ltl::FormatError with line and column, naming the value: "motion[3][0]: expected a number".
Motion parse_motion(std::string_view json, std::string_view source = "");

// "x,y,heading", or "x,y": facing north. Throws ltl::FormatError.
Configuration parse_configuration(std::string_view text);

}  // namespace waymark::plan
