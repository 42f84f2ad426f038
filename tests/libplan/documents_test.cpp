// The examples of docs/formats/maps-and-routes.md are what the readers read.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "libplan/world/trajectory.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

std::string page() {
  std::ifstream in(std::filesystem::path(WAYMARK_SOURCE_DIR) / "docs" / "formats" / "maps-and-routes.md");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// The fenced blocks opened by ```tag.
std::vector<std::string> blocks(const std::string& tag) {
  const std::string text = page(), fence = "```" + tag + "\n";
  std::vector<std::string> out;
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    out.push_back(text.substr(at, text.find("```", at) - at));
  }
  return out;
}

Map annex() { return parse_map(blocks("json map").at(0)); }

TEST(Documents, TheExampleMapIsRead) {
  ASSERT_EQ(blocks("json map").size(), 1U);
  EXPECT_EQ(annex().name(), "annex");
  EXPECT_EQ(annex().nodes().size(), 4U);
  EXPECT_EQ(annex().edges().size(), 3U);
}

// The last column of the table of propositions, all rows together, is the label of 1,0,90.
TEST(Documents, TheExampleLabelIsTheLabel) {
  std::istringstream lines(page());
  std::vector<std::string> documented;
  bool in_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with("| here |"))
      in_table = true;
    else if (!line.starts_with("|"))
      in_table = false;
    if (!in_table || line.starts_with("|---")) continue;
    const std::size_t last = line.rfind('|', line.size() - 2);
    std::istringstream cell(line.substr(last + 1, line.size() - last - 2));
    for (std::string word; cell >> word;)
      if (word.front() == '`') documented.push_back(word.substr(1, word.size() - 2));
  }
  const Map map = annex();
  std::vector<std::string> actual;
  for (ltl::Proposition p : map.label(pose_at(map, 1, 0, 90)).members()) actual.push_back(map.vocabulary().name(p));
  std::sort(documented.begin(), documented.end());
  std::sort(actual.begin(), actual.end());
  EXPECT_EQ(documented, actual);
}

TEST(Documents, TheExampleTrajectoriesAreOne) {
  const Map map = annex();
  std::vector<std::string> texts = blocks("json trajectory");
  for (const std::string& text : blocks("text trajectory")) texts.push_back(text);
  ASSERT_EQ(texts.size(), 4U);
  const Walk endless = parse_walk(texts.back(), map);
  EXPECT_EQ(show(endless.trajectory, map), "0,0,90 FORWARD RIGHT FORWARD RIGHT RIGHT FORWARD RIGHT");
  EXPECT_EQ(endless.repeated, 6U);
  texts.pop_back();
  for (const std::string& text : texts)
    EXPECT_EQ(show(parse_trajectory(text, map), map), "0,0,0 RIGHT FORWARD FORWARD") << text;
}

}  // namespace
}  // namespace waymark::plan
