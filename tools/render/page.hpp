// The page of a map: the task as title, the map with the route, the automaton and the legend beside it.
#pragma once
#include <optional>
#include <string>

#include "libplan/motion/motion.hpp"
#include "libplan/world/trajectory.hpp"
#include "tools/render/automaton_picture.hpp"

namespace waymark::render {

struct Page {
  const plan::Map* map = nullptr;
  std::string instruction = {};  // the English text; may be empty
  std::string formula = {};      // in Unicode notation; may be empty
  std::string caption = {};      // one line of facts; may be empty
  std::optional<plan::Trajectory> route = {};
  std::size_t repeated = 0;  // so many actions at the end of the route are walked for ever
  std::optional<plan::CertifiedMotion> motion = {};
  std::optional<Drawing> automaton = {};
  std::string automaton_caption = {};  // "5 states, 11 edges"
};

// A complete SVG document.
std::string draw_page(const Page& page);

// For pages of other kinds: the root element on a white ground, to be closed by the caller; and a formula with U, R, W,
// M as plain letters, for some of the operators of mathematics are missing from common fonts.
void open_document(Svg& svg, double width, double height);
std::string drawable(std::string formula);

}  // namespace waymark::render
