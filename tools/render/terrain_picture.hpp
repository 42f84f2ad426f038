// The page of a terrain: the task as title, the terrain with the motion, the automaton beside it.
#pragma once
#include <optional>
#include <string>

#include "libplan/motion/tour.hpp"
#include "tools/render/motion_picture.hpp"

namespace waymark::render {

struct TerrainPage {
  const plan::Terrain* terrain = nullptr;
  std::string formula = {};  // in Unicode notation
  std::string caption = {};  // one line of facts
  std::optional<plan::CertifiedTour> motion = {};
  std::optional<Drawing> automaton = {};
};
std::string draw_page(const TerrainPage& page);  // a complete SVG document

}  // namespace waymark::render
