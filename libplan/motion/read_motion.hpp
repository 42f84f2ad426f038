// Motions from JSON: {"motion":[[x,y,heading],…],"radius":r}, as `waymark move --json` answers, of a car with
// "car":{"length":l,"width":w,"turning_radius":r} in the place of the radius; other keys are passed over. Whether the motion is one of a robot in a workspace is the business of route_of and certify.
#pragma once
#include <string_view>

#include "libplan/motion/motion.hpp"

namespace waymark::plan {

// Throws ltl::FormatError with line and column, naming the value: "motion[3][0]: expected a number".
Motion parse_motion(std::string_view json, std::string_view source = "");

// "x,y,heading", or "x,y": facing north. Throws ltl::FormatError.
Configuration parse_configuration(std::string_view text);

}  // namespace waymark::plan
