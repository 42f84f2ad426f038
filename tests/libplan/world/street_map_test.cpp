#include "libplan/world/street_map.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {
namespace {

// Joined (b to c before a to b), with two lengths for a way and two positions for a landmark.
constexpr std::string_view both_views = R"({"name": "t", "nodes": [
  {"id": 4, "name": "A", "x": 0, "y": 0, "u": 10, "v": 20}, {"id": 7, "name": "Red-Lion's", "x": 3, "y": 4},
  {"id": 5, "name": "C", "x": 5, "y": 4}],
  "edges": [{"a": 7, "b": 5, "metres": 2}, {"a": 4, "b": 7, "metres": 5, "length": 0.5}]})";

TEST(StreetMap, IsReadAsThePictureShowsIt) {
  const StreetMap map = parse_street_map(both_views, StreetView::Picture);
  EXPECT_EQ(map.name, "t");
  EXPECT_EQ(map.landmarks[0].right, 10);
  EXPECT_EQ(map.landmarks[0].up, 20);
  EXPECT_EQ(map.landmarks[1].right, 3);
  EXPECT_EQ(map.find(5), LandmarkIndex{2});
  EXPECT_EQ(map.find(6), std::nullopt);
  EXPECT_EQ(map.length(1, 0), 0.5);
  EXPECT_EQ(map.length(1, 2), 2);
  EXPECT_EQ(map.length(0, 2), std::nullopt);
  EXPECT_EQ(map.distance(1, 2), 2);
  ASSERT_EQ(map.ways[1].size(), 2U);
  EXPECT_EQ(map.ways[1][0].to, LandmarkIndex{2});  // in the order of the file
}

TEST(StreetMap, IsReadAsItIsOnTheGround) {
  EXPECT_EQ(parse_street_map(both_views, StreetView::Ground).length(0, 1), 5);
  const auto read = [](const char* json) { return parse_street_map(json, StreetView::Ground); };
  // Neither the map's name nor positions are asked for.
  EXPECT_EQ(read(R"({"nodes": [{"id": 1, "name": "A"}], "edges": []})").landmarks.size(), 1U);
  EXPECT_THROW(parse_street_map(R"({"nodes": [{"id": 1, "name": "A"}], "edges": []})", StreetView::Picture),
               ltl::FormatError);
}

TEST(StreetMap, SaysWhatIsWrongAndWhere) {
  const auto complaint = [](std::string_view nodes, std::string_view edges, StreetView view) {
    const std::string json =
        R"({"name": "t", "nodes": [)" + std::string(nodes) + R"(], "edges": [)" + std::string(edges) + "]}";
    try {
      parse_street_map(json, view, "town.json");
    } catch (const ltl::FormatError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  constexpr std::string_view nodes =
      R"({"id": 0, "name": "Old Mill", "x": 0, "y": 0}, {"id": 1, "name": "old mill", "x": 1, "y": 0})";
  constexpr std::string_view way = R"({"a": 0, "b": 1, "metres": 1})";
  struct Case {
    std::string_view nodes, edges;
    StreetView view;
    const char* complaint;
  };
  const std::string twice = std::string(way) + ", " + std::string(way);
  for (const Case& c : std::initializer_list<Case>{
           {nodes, way, StreetView::Picture, "nothing"},
           {nodes, way, StreetView::Ground, "two landmarks are called old_mill"},
           {nodes, twice, StreetView::Picture, "two ways join"},
           {nodes, R"({"a": 0, "b": 2, "metres": 1})", StreetView::Picture, "no landmark with that id"},
           {nodes, R"({"a": 0, "b": 1, "metres": -1})", StreetView::Picture, "expected a length from 0"},
           {nodes, R"({"a": 0, "b": 0, "metres": 1})", StreetView::Picture, "to itself"},
           {R"({"id": 0, "name": "'", "x": 0, "y": 0})", "", StreetView::Picture, "without a name"},
           {"", "", StreetView::Picture, "without landmarks"}})
    EXPECT_NE(complaint(c.nodes, c.edges, c.view).find(c.complaint), std::string::npos) << c.complaint;
}

TEST(StreetMap, CallsPropositionsInSnakeCase) {
  EXPECT_EQ(landmark_name("Ashley's & Co."), "ashleys_co");
  EXPECT_EQ(landmark_name("7-Eleven"), "7_eleven");
  EXPECT_EQ(landmark_name("Così"), "così");
}

}  // namespace
}  // namespace waymark::plan
