// Extracts of OpenStreetMap read in a stream, against the same extracts read as a document, and by hand.
#include "libplan/model/formats/osm_roads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>

#include "libltl/diagnostic.hpp"
#include "libltl/structure/random.hpp"
#include "libplan/model/formats/globe_points.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/model/formats/read_osm.hpp"
#include "libplan/model/formats/xml_stream.hpp"

namespace waymark::plan {
namespace {

struct Written {
  OsmRoads made;
  std::string gr, co, lab;
};
Written written(const std::string& xml, const OsmChoice& choice = {}) {
  std::istringstream osm(xml);
  std::ostringstream gr, co, lab;
  const OsmRoads made = write_osm_roads(osm, "x.osm", choice, gr, co, lab);
  return {made, gr.str(), co.str(), lab.str()};
}
RoadGraph parsed(const Written& files) {
  std::istringstream gr(files.gr), lab(files.lab);
  return parse_dimacs(gr, lab, "x.gr");
}
std::string message(const std::string& xml, const OsmChoice& choice = {}) {
  try {
    written(xml, choice);
  } catch (const ltl::FormatError& error) {
    return std::to_string(error.line()) + ": " + error.what();
  }
  return "read";
}

// Streets, one-way streets, areas and landmarks between random points; some nodes are missing.
std::string random_extract(ltl::Random& random) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(7) << "<?xml version='1.0'?>\n<osm version=\"0.6\">\n<!-- <node> -->\n";
  const std::size_t nodes = 3 + random.below(20);
  const double side = random.chance(0.2) ? 100 : 0.01;
  for (std::size_t v = 1; v <= nodes; ++v) {
    if (v > 2 && random.chance(0.1)) continue;
    out << "<node id='" << v << "' lon=\"" << side * (random.unit() - 0.5) << "\" lat='"
        << 0.8 * side * (random.unit() - 0.5) << "'";
    if (random.chance(0.3))
      out << "><tag k='name' v='Place " << random.below(4) << "'/></node>\n";
    else
      out << "/>\n";
  }
  const char* const oneway[] = {"", "<tag k='oneway' v='yes'/>", "<tag k='oneway' v='-1'/>",
                                "<tag k='junction' v='roundabout'/>", "<tag k='name' v='A &amp; B Street'/>"};
  out << "<way id='7'><nd ref='1'/><nd ref='2'/><tag k='highway' v='road'/></way>\n";
  for (std::size_t w = 0; w < 12; ++w) {
    out << "<way id='" << w << "'>";
    const std::size_t first = 1 + random.below(nodes), length = 1 + random.below(5);
    out << "<nd ref='" << first << "'/>";
    for (std::size_t i = 0; i < length; ++i) out << "<nd ref='" << 1 + random.below(nodes) << "'/>";
    if (random.chance(0.4))
      out << "<nd ref='" << first << "'/><tag k='name' v='Park &#34;" << w << "'/>";
    else
      out << "<tag k='highway' v='residential'/>" << oneway[random.below(5)];
    out << "</way>\n";
  }
  out << "<relation id='1'><member type='node' ref='1'/><tag k='name' v='No'/></relation></osm>\n";
  return out.str();
}

using Moves = std::set<std::tuple<long, long, long, std::string>>;  // from, to, centimetres, letter there

TEST(OsmRoads, AreThoseOfTheDocument) {
  ltl::Random random(1);
  std::size_t compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string xml = random_extract(random);
    std::optional<Mdp> model;
    try {
      model.emplace(parse_osm(xml));
    } catch (const ltl::FormatError& error) {  // the same is wrong with both
      ASSERT_NE(message(xml).find(std::string(error.what()).substr(0, 16)), std::string::npos) << error.what() << xml;
      continue;
    }
    ++compared;
    const RoadGraph graph = parsed(written(xml));
    std::vector<long> ids;  // of the nodes, ascending
    for (std::uint32_t s = 0; s < model->states(); ++s) ids.push_back(std::stol(std::string(model->name(s))));
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(graph.nodes(), ids.size()) << xml;
    Moves expected, found;
    const auto letter = [](const ltl::Letter& l, const ltl::Vocabulary& names) {
      std::set<std::string> out;
      for (const ltl::Proposition p : l.members()) out.insert(names.name(p));
      std::string text;
      for (const std::string& name : out) text += name + ' ';
      return text;
    };
    for (std::uint32_t s = 0; s < model->states(); ++s)
      for (std::uint32_t k = 0; k < model->choices(s); ++k) {
        const ModelOutcome& o = model->outcome(s, k, 0);
        expected.emplace(std::stol(std::string(model->name(s))), std::stol(std::string(model->name(o.target))),
                         std::lround(100 * model->cost(s, k)),
                         letter(model->letters()[o.letter], model->letters().vocabulary()));
      }
    for (std::uint32_t v = 0; v < graph.nodes(); ++v)
      for (const RoadGraph::Arc& arc : graph.arcs(v))
        found.emplace(ids[v], ids[arc.to], arc.cost,
                      letter(graph.letters()[graph.letter(arc.to)], graph.letters().vocabulary()));
    ASSERT_EQ(found, expected) << xml;
  }
  EXPECT_GT(compared, 1000U);
}

constexpr const char* village = R"(<?xml version="1.0"?><!DOCTYPE osm><osm version="0.6">
<bounds minlat="0" maxlat="1"/>
<node id="-3" lon="0" lat="0"/><node id="20000000000" lon="0.001" lat="0"><tag k="amenity" v="fuel"/></node>
<node id="4" lon="0.002" lat="0"><tag k="name" v="Init"/></node>
<node id="5" lon="-0.0005" lat="-0.0005"/><node id="6" lon="0.0005" lat="-0.0005"/><node id="7" lon="0" lat="0.0005"/>
<way id="1"><nd ref="-3"/><nd ref="20000000000"/><nd ref="9"/><nd ref="4"/><tag k="highway" v="motorway"/></way>
<way id="2"><nd ref="4"/><nd ref="20000000000"/><tag k="highway" v="track"/><tag k="name" v="Long Lane"/></way>
<way id="3"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="5"/><tag k="name" v="Wood"/></way></osm>)";

TEST(OsmRoads, AreWrittenByIdWithLandmarksByNameAndTag) {
  const Written all = written(village);
  EXPECT_EQ(all.gr,
            "c points of roads of OpenStreetMap by their ids, costs in centimetres\n"
            "p sp           3           3\na 1 3 11120\na 2 3 11120\na 3 2 11120\n");
  EXPECT_EQ(all.co, "c longitude and latitude in 10^-7 degrees\np aux sp co 3\nv 1 0 0\nv 2 20000 0\nv 3 10000 0\n");
  EXPECT_EQ(all.lab, "0=\"wood\" 1=\"init_\"\n1: 0\n2: 1\n");
  EXPECT_EQ(all.made.missing, 1U);
  EXPECT_EQ(all.made.labelled, 2U);
  EXPECT_EQ(written(village, {{"wood"}, {{"amenity", "fuel"}}}).lab, "0=\"wood\" 1=\"fuel\"\n1: 0\n3: 1\n");
  EXPECT_EQ(written(village, {{}, {{"amenity", "fuel"}}}).lab, "0=\"fuel\"\n3: 0\n");
}

TEST(OsmRoads, RefusalsNameTheLine) {
  EXPECT_NE(message(village, {{"long_lane"}, {}}).find("no landmark 'long_lane'"), std::string::npos);
  EXPECT_NE(message(village, {{}, {{"amenity", "bank"}}}).find("amenity=bank"), std::string::npos);
  const std::string road = "<way><nd ref='1'/><nd ref='2'/><tag k='highway' v='x'/></way>\n",
                    nodes =
                        "<node id='1' lon='0' lat='0'><tag k='name' v='A'/></node>\n<node id='2' lon='1' lat='0'/>\n";
  EXPECT_EQ(message("<osm>" + nodes + road + "</osm>"), "read");
  const std::pair<std::string, std::string> wrong[] = {
      {"<osm><node id='2' lon='0' lat='0'/>\n" + road + nodes + "</osm>", "3: "},
      {"<osm>" + nodes + nodes + road + "</osm>", "3: "},
      {"<osm>\n<node id='1' lon='181' lat='0'/>" + road + "</osm>", "2: "},
      {"<osm>\n<node id='1' lon='nan' lat='0'/>" + road + "</osm>", "2: "},
      {"<osm>\n<node id='1' lat='0'/>" + road + "</osm>", "2: "},
      {"<osm>\n<way><nd ref='1.5'/></way></osm>", "2: "},
      {"<osm>" + nodes + road, "4: "},
      {"<osm>\n\n<way></node></osm>", "3: "},
      {"<osm>\n<node id=1/></osm>", "2: "},
      {"<osm>\n<node id='1'", "2: "},
      {"<osm>\n<!-- ", "2: "},
      {"<osm/><osm/>", "1: "},
      {"<gpx/>", "1: "},
      {"", "1: "},
      {"<osm>\n<way><nd ref='&one;'/></way></osm>", "2: "},
  };
  for (const auto& [xml, line] : wrong)
    EXPECT_EQ(message(xml).substr(0, line.size()), line) << xml << '\n' << message(xml);
  for (const std::string& xml :
       {"<osm>" + nodes + "</osm>", "<osm>" + road + "</osm>", "<osm>" + road + nodes + "</osm>"})
    EXPECT_NE(message(xml).find("there is no road"), std::string::npos) << xml;
}

// Tags that lie across the blocks in which a file is read, by text before them of every length around a block.
TEST(XmlStream, ReadsAcrossBlocks) {
  for (std::size_t pad = (std::size_t{1} << 20U) - 60; pad < (std::size_t{1} << 20U) + 5; ++pad) {
    std::istringstream in("<osm>" + std::string(pad, ' ') +
                          "<!-- x --><node id='a>&lt;&#x1F600;' \n b=\"'\"/>text</osm>");
    XmlStream xml(in, "x");
    ASSERT_EQ(xml.next(), XmlStream::Event::Begin);
    ASSERT_EQ(xml.next(), XmlStream::Event::Begin);
    ASSERT_EQ(xml.name(), "node");
    ASSERT_EQ(xml.attribute("id"), "a><\xF0\x9F\x98\x80") << pad;
    ASSERT_EQ(xml.attribute("b"), "'");
    ASSERT_FALSE(xml.attribute("c"));
    ASSERT_EQ(xml.depth(), 2U);
    ASSERT_EQ(xml.next(), XmlStream::Event::End);
    ASSERT_EQ(xml.next(), XmlStream::Event::End);
    ASSERT_EQ(xml.name(), "osm");
    ASSERT_EQ(xml.next(), XmlStream::Event::Over);
  }
}

TEST(GlobePoints, AreTheNearestAndThoseInABox) {
  ltl::Random random(4);
  for (int i = 0; i < 300; ++i) {
    const std::int32_t span = random.chance(0.5) ? 20 : 180;  // degrees
    const auto draw = [&] {
      const auto part = [&](int most) {
        return static_cast<std::int32_t>((2 * random.unit() - 1) * most * FixedPoint::degree);
      };
      const bool far = span == 180 && random.chance(0.3);  // near the poles and the meridian of 180 degrees
      return far ? FixedPoint{(random.chance(0.5) ? 1 : -1) * (179 * FixedPoint::degree + 9'999'000),
                              (random.chance(0.5) ? 1 : -1) * 89 * FixedPoint::degree + part(1)}
                 : FixedPoint{part(span), part(span / 2)};
    };
    std::vector<FixedPoint> points;
    for (std::size_t n = 1 + random.below(60); n > 0; --n) points.push_back(draw());
    if (random.chance(0.3)) points.push_back(points.front());
    const GlobePoints tree(points);
    for (int k = 0; k < 20; ++k) {
      const FixedPoint to = draw(), other = draw();
      const std::uint32_t found = tree.nearest(to);
      for (std::uint32_t v = 0; v < points.size(); ++v)
        ASSERT_LE(metres(to, points[found]), metres(to, points[v]) + 1e-6) << "case " << i;
      const FixedPoint low{std::min(to.longitude, other.longitude), std::min(to.latitude, other.latitude)},
          high{std::max(to.longitude, other.longitude), std::max(to.latitude, other.latitude)};
      std::set<std::uint32_t> inside, expected;
      tree.for_each_in(low, high, [&](std::uint32_t v) { ASSERT_TRUE(inside.insert(v).second); });
      for (std::uint32_t v = 0; v < points.size(); ++v)
        if (low.longitude <= points[v].longitude && points[v].longitude <= high.longitude &&
            low.latitude <= points[v].latitude && points[v].latitude <= high.latitude)
          expected.insert(v);
      ASSERT_EQ(inside, expected) << "case " << i;
    }
  }
}

}  // namespace
}  // namespace waymark::plan
