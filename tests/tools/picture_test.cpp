// Pictures: well-formed, complete, and with nothing outside the page.
#include <gtest/gtest.h>

#include <regex>
#include <vector>

#include "libplan/world/read_map.hpp"
#include "tools/render/page.hpp"

namespace waymark::render {
namespace {

// The first element that is not closed by its own name, or the leftover; "" when the document is well nested.
std::string first_fault(const std::string& svg) {
  static const std::regex tag(R"(<(/?)([A-Za-z:]+)((?:"[^"]*"|'[^']*'|[^>"'])*?)(/?)>)");
  std::vector<std::string> open;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), tag); it != std::sregex_iterator(); ++it) {
    const std::string name = (*it)[2];
    if ((*it)[4].length() > 0) continue;
    if ((*it)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> at byte " + std::to_string(it->position());
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

plan::Map shipped(const std::string& name) { return plan::read_map(name, WAYMARK_DATA_FOLDER); }

Page page_of(const plan::Map& map) {
  Page page;
  page.map = &map;
  return page;
}

TEST(Picture, OfEveryShippedMapIsWellFormedAndComplete) {
  for (const std::string& name : plan::shipped_maps(WAYMARK_DATA_FOLDER)) {
    const plan::Map map = shipped(name);
    const std::string svg = draw_page(page_of(map));
    EXPECT_EQ(first_fault(svg), "") << name;
    const std::size_t in_legend = map.walls().size();
    EXPECT_EQ(occurrences(svg, "stroke=\"#6b4a1c\""), map.edges().size() + in_legend) << name << ": frames";
  }
}

TEST(Picture, OfARouteNumbersEveryAction) {
  const plan::Map map = shipped("grid");
  Page page = page_of(map);
  page.route = plan::parse_trajectory("1,9,0 FORWARD FORWARD RIGHT RIGHT FORWARD LEFT", map);
  page.instruction = "there & <back>";
  const std::string svg = draw_page(page);
  EXPECT_EQ(first_fault(svg), "");
  EXPECT_NE(svg.find("there &amp; &lt;back&gt;"), std::string::npos);
  for (const std::string step : {"1", "2", "3", "4", "5", "6"})
    EXPECT_NE(svg.find(">" + step + "</text>"), std::string::npos);
}

TEST(Picture, GathersTheNumbersOfActionsInOnePlace) {
  const plan::Map map = shipped("grid");
  Page page = page_of(map);
  page.route = plan::parse_trajectory("1,9,0 LEFT LEFT LEFT LEFT LEFT", map);
  EXPECT_NE(draw_page(page).find(">1, 5</text>"), std::string::npos);
}

TEST(Picture, ShowsMapsWithOtherThingsInThem) {
  const std::vector<plan::Node> nodes{{0, 0, "piano", 12}, {1, 0, "extraordinarily", std::nullopt}};
  const std::vector<plan::Edge> edges{{0, 1, "marble", "Ümit"}};
  const plan::Map map("hall", nodes, edges, {"piano", "extraordinarily"}, {"marble"}, {"Ümit"});
  const std::string svg = draw_page(page_of(map));
  EXPECT_EQ(first_fault(svg), "");
  EXPECT_NE(svg.find(">piano</text>"), std::string::npos);
  EXPECT_NE(svg.find(">ex</text>"), std::string::npos);  // too long to be written out
  EXPECT_NE(svg.find(">Üm</text>"), std::string::npos);
  EXPECT_NE(svg.find(">#12</text>"), std::string::npos);
}

TEST(Picture, EmbedsAnAutomatonThatGraphvizDrew) {
  const Drawing drawing = drawing_of(
      "<?xml version=\"1.0\"?>\n<!-- > -->\n<svg width=\"8pt\"\n viewBox=\"0.00 0.00 62.00 44.50\" "
      "xmlns=\"x\">\n<g><path d=\"M1 1\"/></g>\n</svg>\n");
  EXPECT_EQ(drawing.width, 62);
  EXPECT_EQ(drawing.height, 44.5);
  EXPECT_EQ(drawing.content, "\n<g><path d=\"M1 1\"/></g>\n");
  EXPECT_THROW(drawing_of("not a picture"), std::runtime_error);
  EXPECT_THROW(drawing_of("<svg viewBox=\"0 0 1\"></svg>"), std::runtime_error);
}

TEST(Svg, WritesNumbersWithoutNoise) {
  EXPECT_EQ(number(1.0), "1");
  EXPECT_EQ(number(-0.001), "0");
  EXPECT_EQ(number(12.345), "12.35");
  EXPECT_EQ(number(100), "100");
}

TEST(Svg, BreaksLinesAtSpacesAndMeasuresCharacters) {
  EXPECT_EQ(wrapped("aa bb cc", text_width("aa bb")), (std::vector<std::string>{"aa bb", "cc"}));
  EXPECT_EQ(wrapped("unbreakable", 1), (std::vector<std::string>{"unbreakable"}));
  EXPECT_TRUE(wrapped("", 10).empty());
  EXPECT_NEAR(text_width("◇"), text_width("○"), 1e-9);
}

}  // namespace
}  // namespace waymark::render
