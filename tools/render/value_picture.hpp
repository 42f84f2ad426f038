// Values and policies on a map: four fields around each place, one for each heading, the darker the better, with the
// value or the action that the policy takes there.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "libplan/world/map.hpp"

namespace waymark::render {

struct PoseMark {
  plan::PoseId pose;
  double share = 0;                         // of the best value, in [0, 1]: 1 is darkest
  std::string value = {};                   // as text; drawn where there is no action
  std::optional<plan::Action> action = {};  // drawn in its stead
};

struct ValuePage {
  const plan::Map* map = nullptr;
  std::string formula = {}, caption = {};
  std::vector<PoseMark> marks = {};
};
std::string draw_values(const ValuePage& page);  // a complete SVG document

}  // namespace waymark::render
