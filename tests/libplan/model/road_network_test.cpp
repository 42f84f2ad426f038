// Roads with landmarks from GeoJSON, OSM XML and GraphML, against models made by hand and definitions written again.
#include "libplan/model/formats/road_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "libltl/diagnostic.hpp"
#include "libltl/word.hpp"
#include "libplan/model/formats/read_geojson.hpp"
#include "libplan/model/formats/read_graphml.hpp"
#include "libplan/model/formats/read_osm.hpp"

namespace waymark::plan {
namespace {

constexpr double degree = 2 * std::numbers::pi * 6'371'008.8 / 360;  // metres, along the equator

// The moves of a model: "1 -2-> 3 {park}", costs in whole metres.
std::set<std::string> moves(const Mdp& model) {
  std::set<std::string> out;
  for (std::uint32_t s = 0; s < model.states(); ++s)
    for (std::uint32_t k = 0; k < model.choices(s); ++k) {
      const ModelOutcome& o = model.outcome(s, k, 0);
      EXPECT_EQ(model.action(s, k), model.name(o.target));
      out.insert(model.name(s) + " -" + std::to_string(std::lround(model.cost(s, k))) + "-> " + model.name(o.target) +
                 " " + ltl::show(model.letters()[o.letter], model.letters().vocabulary()));
    }
  return out;
}

constexpr const char* town_geojson = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": null,
   "geometry": {"type": "LineString", "coordinates": [[0, 0], [0.001, 0], [0.002, 0]]}},
  {"type": "Feature", "properties": {"oneway": true},
   "geometry": {"type": "MultiLineString", "coordinates": [[[0.001, 0], [0.001, 0.001, 12]]]}},
  {"type": "Feature", "properties": {"name": "Town Hall"},
   "geometry": {"type": "Point", "coordinates": [0.0021, 0.0001]}},
  {"type": "Feature", "properties": {"name": "Lost"}, "geometry": null},
  {"type": "Feature", "properties": {"name": "Park"}, "geometry": {"type": "Polygon", "coordinates": [
     [[-0.01, -0.01], [0.001, -0.01], [0.001, 0.01], [-0.01, 0.01], [-0.01, -0.01]],
     [[-0.001, -0.001], [0.0005, -0.001], [0.0005, 0.001], [-0.001, 0.001]]]}}]})";

TEST(GeoJson, LinesAreRoadsAndWhatHasANameIsALandmark) {
  const Mdp model = parse_geojson(town_geojson, "town.geojson", "0,0");
  EXPECT_EQ(model.states(), 4U);
  EXPECT_EQ(model.name(model.initial()), "0,0");
  EXPECT_EQ(moves(model), (std::set<std::string>{"0,0 -111-> 0.001,0 {park}", "0.001,0 -111-> 0,0 {}",
                                                 "0.001,0 -111-> 0.002,0 {town_hall}", "0.002,0 -111-> 0.001,0 {park}",
                                                 "0.001,0 -111-> 0.001,0.001 {park}"}));
  EXPECT_EQ(parse_geojson(town_geojson, "", "town_hall").initial(), 2U);
  EXPECT_EQ(parse_geojson(town_geojson).initial(), 1U);  // the first with a landmark
}

TEST(Osm, StreetsRespectOnewayAndEndWhereTheExtractEnds) {
  const Mdp model = parse_osm(R"(<?xml version="1.0"?><osm version="0.6">
<node id="1" lon="0" lat="0"/><node id="2" lon="0.001" lat="0"/><node id="3" lon="0.002" lat="0"/>
<node id="4" lon="0.002" lat="0.001"/><node id="7" lon="0.0021" lat="0"><tag k="name" v="Joe's Inn"/></node>
<way id="20"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>
<way id="21"><nd ref="2"/><nd ref="3"/><tag k="highway" v="primary"/><tag k="oneway" v="-1"/></way>
<way id="22"><nd ref="3"/><nd ref="4"/><nd ref="99"/><nd ref="1"/><tag k="highway" v="motorway"/></way>
<way id="23"><nd ref="1"/><nd ref="2"/><nd ref="4"/><nd ref="1"/><tag k="name" v="Pond"/></way>
<way id="24"><nd ref="1"/><nd ref="2"/><tag k="waterway" v="river"/></way>
<relation id="5"/></osm>)",
                              "town.osm");
  EXPECT_EQ(moves(model), (std::set<std::string>{"1 -111-> 2 {pond}", "2 -111-> 1 {pond}", "3 -111-> 2 {pond}",
                                                 "3 -111-> 4 {pond}"}));
  EXPECT_EQ(ltl::show(model.letters()[model.initial_letter()], model.letters().vocabulary()), "{pond}");
  EXPECT_TRUE(model.letters().vocabulary().find("joes_inn"));
}

TEST(Graphml, EdgesAreRoadsInTheirDirections) {
  const Mdp model = parse_graphml(R"(<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
<key id="d0" for="node" attr.name="name" attr.type="string"/>
<key id="d1" for="edge" attr.name="length" attr.type="double"><default>7</default></key>
<graph edgedefault="undirected">
<node id="a"><data key="d0">Main Gate</data></node><node id="b"/><node id="c"/>
<edge source="a" target="b"><data key="d1">3.4</data></edge>
<edge source="b" target="c" directed="true"/></graph></graphml>)",
                                  "", "b");
  EXPECT_EQ(moves(model), (std::set<std::string>{"a -3-> b {}", "b -3-> a {main_gate}", "b -7-> c {}"}));
  EXPECT_EQ(model.initial(), 1U);
}

TEST(Roads, ErrorsNameThePlace) {
  struct Row {
    Mdp (*parse)(std::string_view, std::string_view, std::string_view);
    const char *text, *message;
    std::size_t line;
  };
  const Row table[] = {
      {parse_geojson, R"({"type": "Feature"})", "expected a \"FeatureCollection\"", 1},
      {parse_geojson, "{\"type\": \"FeatureCollection\",\n\"features\": [{\"geometry\": {\"type\": \"Cube\"}}]}",
       "expected a Point", 2},
      {parse_geojson,
       "{\"type\": \"FeatureCollection\", \"features\": [{\"geometry\":\n{\"type\": \"Point\", \"coordinates\": [181, "
       "0]}}]}",
       "longitude within", 2},
      {parse_geojson, R"({"type": "FeatureCollection", "features": []})", "there is no road", 0},
      {parse_osm, "<osm>\n<node id='1' lon='0'/></osm>", "no attribute lat", 2},
      {parse_osm, "<osm>\n<node id='1' lon='0' lat='x'/></osm>", "expected a number, not 'x'", 2},
      {parse_osm, "<osm>\n<node id='1' lon='0' lat='0'/>\n<node id='1' lon='0' lat='0'/></osm>",
       "two nodes have this id", 3},
      {parse_osm, "<osm>", "malformed XML", 1},
      {parse_osm, "<map/>", "expected <osm>", 1},
      {parse_graphml, "<graphml>\n</graphml>", "expected a <graph>", 1},
      {parse_graphml,
       "<graphml><graph edgedefault='directed'>\n<node id='a'/><edge source='a' target='b'/></graph></graphml>",
       "target: there is no node", 2},
      {parse_graphml, "<graphml><graph edgedefault='directed'>\n<hyperedge/></graph></graphml>", "hyperedges", 2},
      {parse_graphml,
       "<graphml><key id='w' for='edge' attr.name='cost'/><graph edgedefault='directed'><node id='a'/>\n"
       "<edge source='a' target='a'><data key='w'>1.1e100</data></edge></graph></graphml>",
       "expected a cost from 0 to 1e100", 2},
      {parse_graphml, "<graphml><graph edgedefault='directed'><node id='a'/></graph></graphml>", "there is no landmark",
       0},
  };
  for (const Row& row : table) {
    try {
      row.parse(row.text, "town", "");
      ADD_FAILURE() << row.text << " was read";
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what();
      EXPECT_EQ(error.line(), row.line) << error.what();
    }
  }
  try {
    parse_geojson(town_geojson, "", "town_hal");
    ADD_FAILURE() << "a start that is not there";
  } catch (const ltl::FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'town_hall'?"), std::string::npos) << error.what();
  }
}

// The haversine formula [Sinnott, Virtues of the haversine, 1984].
double haversine(const GlobePoint& a, const GlobePoint& b) {
  const double r = std::numbers::pi / 180, u = std::sin((b.latitude - a.latitude) * r / 2),
               v = std::sin((b.longitude - a.longitude) * r / 2);
  return 2 * 6'371'008.8 * std::asin(std::sqrt(u * u + std::cos(a.latitude * r) * std::cos(b.latitude * r) * v * v));
}

// At every latitude, across the antimeridian and around the poles.
TEST(GlobeRoads, ALandmarkStandsAtTheNearestPointAndRoadsHaveTheirLengths) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> longitude(-180, 180), latitude(-90, 90);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<GlobePoint> points;
    GlobeRoads roads("");
    for (int i = 0; i < 20; ++i) {
      points.push_back({longitude(random), latitude(random)});
      roads.add_point(points.back(), std::to_string(i));
      if (i > 0)
        roads.add_road(static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i),
                       GlobeRoads::Direction::Forward);
    }
    const GlobePoint place{longitude(random), latitude(random)};
    roads.add_landmark(place, "Here");
    const RoadNetwork network = std::move(roads).build();
    double least = 1e9, found = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i) {
      least = std::min(least, haversine(place, points[i]));
      if (!network.nodes[i].landmarks.empty()) found = haversine(place, points[i]);
      if (i + 1 < points.size()) {
        ASSERT_NEAR(network.nodes[i].roads.at(0).cost, haversine(points[i], points[i + 1]), 0.1) << "trial " << trial;
      }
    }
    ASSERT_NEAR(found, least, 0.1) << "trial " << trial;
  }
}

TEST(GlobeRoads, AnAreaHoldsThePointsInsideItAndNotThoseInItsHoles) {
  const GlobeRoads::Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, hole{{4, 4}, {6, 4}, {6, 6}, {4, 6}, {4, 4}};
  GlobeRoads roads("");
  for (int x = -1; x <= 11; ++x)
    for (int y = -1; y <= 11; ++y)
      roads.add_point({static_cast<double>(x), static_cast<double>(y)}, std::to_string(x) + "," + std::to_string(y));
  roads.add_area({square, hole}, "Lake");
  const RoadNetwork network = std::move(roads).build();
  std::size_t i = 0;
  for (int x = -1; x <= 11; ++x)
    for (int y = -1; y <= 11; ++y, ++i) {
      const bool inside = x >= 0 && x <= 10 && y >= 0 && y <= 10 && !(x == 5 && y == 5);
      EXPECT_EQ(!network.nodes[i].landmarks.empty(), inside) << x << "," << y;
    }
}

TEST(GlobeRoads, AnEquatorsDegreeIsThatLong) {
  GlobeRoads roads("");
  roads.add_point({179.5, 0}, "a");
  roads.add_point({-179.5, 0}, "b");
  roads.add_road(0, 1, GlobeRoads::Direction::Backward);
  const RoadNetwork network = std::move(roads).build();
  EXPECT_TRUE(network.nodes[0].roads.empty());
  EXPECT_NEAR(network.nodes[1].roads.at(0).cost, degree, 0.01);
}

}  // namespace
}  // namespace waymark::plan
