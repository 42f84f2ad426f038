#include "libplan/model/formats/read_osm.hpp"

#include <string>
#include <unordered_map>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/road_network.hpp"
#include "libplan/model/formats/xml_document.hpp"

namespace waymark::plan {
namespace {

std::string_view tag(const pugi::xml_node& element, const char* key) {
  return element.find_child_by_attribute("tag", "k", key).attribute("v").value();
}

GlobeRoads::Direction direction_of(const pugi::xml_node& way) {
  const std::string_view oneway = tag(way, "oneway");
  if (oneway == "-1" || oneway == "reverse") return GlobeRoads::Direction::Backward;
  if (oneway == "yes" || oneway == "true" || oneway == "1") return GlobeRoads::Direction::Forward;
  if (oneway.empty() && (tag(way, "junction") == "roundabout" || tag(way, "highway") == "motorway"))
    return GlobeRoads::Direction::Forward;
  return GlobeRoads::Direction::Both;
}

class OsmReader {
 public:
  OsmReader(std::string_view xml, std::string_view source) : xml_(xml, source), roads_(source) {}

  RoadNetwork read() {
    const pugi::xml_node root = xml_.root("osm");
    for (const pugi::xml_node& node : root.children("node")) add_node(node);
    for (const pugi::xml_node& way : root.children("way")) add_way(way);
    return std::move(roads_).build();
  }

 private:
  void add_node(const pugi::xml_node& node) {
    const GlobePoint at{xml_.number(node, xml_.attribute(node, "lon")), xml_.number(node, xml_.attribute(node, "lat"))};
    if (at.longitude < -180 || at.longitude > 180 || at.latitude < -90 || at.latitude > 90)
      xml_.fail(node, "expected a longitude within ±180 and a latitude within ±90");
    if (!nodes_.emplace(xml_.attribute(node, "id"), at).second) xml_.fail(node, "two nodes have this id");
    roads_.add_landmark(at, tag(node, "name"));
  }

  void add_way(const pugi::xml_node& way) {
    if (!tag(way, "highway").empty())
      add_street(way);
    else if (!tag(way, "name").empty())
      add_area(way);
  }

  void add_street(const pugi::xml_node& way) {
    const GlobeRoads::Direction direction = direction_of(way);
    std::uint32_t last = GlobeRoads::no_point;
    for (const pugi::xml_node& nd : way.children("nd")) {
      const auto found = nodes_.find(xml_.attribute(nd, "ref"));
      if (found == nodes_.end()) {  // outside the extract, which cuts the street here
        last = GlobeRoads::no_point;
        continue;
      }
      const std::uint32_t here = roads_.add_point(found->second, found->first);
      if (last != GlobeRoads::no_point) roads_.add_road(last, here, direction);
      last = here;
    }
  }

  void add_area(const pugi::xml_node& way) {
    GlobeRoads::Ring ring;
    std::string first, last;
    for (const pugi::xml_node& nd : way.children("nd")) {
      last = xml_.attribute(nd, "ref");
      if (ring.empty()) first = last;
      const auto found = nodes_.find(last);
      if (found == nodes_.end()) return;  // not all of it is in the extract
      ring.push_back(found->second);
    }
    if (ring.size() > 3 && first == last) roads_.add_area({ring}, tag(way, "name"));
  }

  XmlDocument xml_;
  GlobeRoads roads_;
  std::unordered_map<std::string, GlobePoint> nodes_;  // by id
};

}  // namespace

Mdp parse_osm(std::string_view xml, std::string_view source, std::string_view start) {
  if (xml.size() > most_road_bytes) throw ltl::FormatError(source, 0, 0, "expected at most 1 GiB");
  return model_of(OsmReader(xml, source).read(), source, start);
}

}  // namespace waymark::plan
