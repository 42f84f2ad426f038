#include "libplan/model/formats/read_geojson.hpp"

#include <charconv>
#include <string>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/road_network.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using Value = JsonReader::Value;

std::string shortest(double number) {
  std::string out(32, ' ');
  out.resize(static_cast<std::size_t>(std::to_chars(out.data(), out.data() + out.size(), number).ptr - out.data()));
  return out;
}

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view json, std::string_view source) : in_(json, source), roads_(source) {}

  RoadNetwork read() {
    const Value document = in_.parse();
    if (!document.is_object() || in_.string(in_.member(document, "", "type"), "type") != "FeatureCollection")
      in_.fail("type", "expected a \"FeatureCollection\"");
    in_.each(document, "", "features", [&](const Value& value, const std::string& path) { feature(value, path); });
    return std::move(roads_).build();
  }

 private:
  void feature(const Value& value, const std::string& path) {
    const Value& geometry = in_.member(value, path, "geometry");
    if (geometry.is_null()) return;  // a feature without a place (RFC 7946, 3.2)
    const std::string here = path + ".geometry", kind = in_.string(in_.member(geometry, here, "type"), here + ".type");
    const std::string name = property(value, "name");
    const auto parts = [&](auto visit) { in_.each(geometry, here, "coordinates", visit); };
    if (kind == "Point") {
      roads_.add_landmark(position(in_.member(geometry, here, "coordinates"), here + ".coordinates"), name);
    } else if (kind == "MultiPoint") {
      parts([&](const Value& p, const std::string& at) { roads_.add_landmark(position(p, at), name); });
    } else if (kind == "LineString") {
      line(in_.member(geometry, here, "coordinates"), here + ".coordinates", direction_of(value));
    } else if (kind == "MultiLineString") {
      parts([&](const Value& part, const std::string& at) { line(part, at, direction_of(value)); });
    } else if (kind == "Polygon") {
      roads_.add_area(rings(in_.member(geometry, here, "coordinates"), here + ".coordinates"), name);
    } else if (kind == "MultiPolygon") {
      parts([&](const Value& part, const std::string& at) { roads_.add_area(rings(part, at), name); });
    } else {
      in_.fail(here + ".type", "expected a Point, LineString or Polygon, or Multi and one of these");
    }
  }

  // A property as text, "" without one.
  static std::string property(const Value& feature, const char* key) {
    const auto properties = feature.find("properties");
    if (properties == feature.end() || !properties->is_object() || !properties->contains(key)) return "";
    const Value& value = (*properties)[key];
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    return value.is_string() ? value.get<std::string>() : "";
  }

  static GlobeRoads::Direction direction_of(const Value& feature) {
    const std::string oneway = property(feature, "oneway");
    if (oneway == "-1") return GlobeRoads::Direction::Backward;
    return oneway == "yes" || oneway == "true" || oneway == "1" ? GlobeRoads::Direction::Forward
                                                                : GlobeRoads::Direction::Both;
  }

  void line(const Value& value, const std::string& path, GlobeRoads::Direction direction) {
    std::uint32_t last = GlobeRoads::no_point;
    for (const GlobePoint& p : positions(value, path)) {
      const std::uint32_t here = roads_.add_point(p, shortest(p.longitude) + "," + shortest(p.latitude));
      if (last != GlobeRoads::no_point) roads_.add_road(last, here, direction);
      last = here;
    }
  }

  std::vector<GlobeRoads::Ring> rings(const Value& value, const std::string& path) const {
    if (!value.is_array()) in_.fail(path, "expected a list of rings");
    std::vector<GlobeRoads::Ring> out;
    for (std::size_t i = 0; i < value.size(); ++i)
      out.push_back(positions(value[i], path + "[" + std::to_string(i) + "]"));
    return out;
  }

  std::vector<GlobePoint> positions(const Value& value, const std::string& path) const {
    if (!value.is_array()) in_.fail(path, "expected a list of positions");
    std::vector<GlobePoint> out;
    for (std::size_t i = 0; i < value.size(); ++i)
      out.push_back(position(value[i], path + "[" + std::to_string(i) + "]"));
    return out;
  }

  GlobePoint position(const Value& value, const std::string& path) const {
    if (!value.is_array() || value.size() < 2) in_.fail(path, "expected a position [longitude, latitude]");
    const GlobePoint p{in_.number(value[0], path + "[0]"), in_.number(value[1], path + "[1]")};
    if (p.longitude < -180 || p.longitude > 180) in_.fail(path + "[0]", "expected a longitude within ±180");
    if (p.latitude < -90 || p.latitude > 90) in_.fail(path + "[1]", "expected a latitude within ±90");
    return p;
  }

  const JsonReader in_;
  GlobeRoads roads_;
};

}  // namespace

Mdp parse_geojson(std::string_view json, std::string_view source, std::string_view start) {
  if (json.size() > most_road_bytes) throw ltl::FormatError(source, 0, 0, "expected at most 1 GiB");
  return model_of(GeoJsonReader(json, source).read(), source, start);
}

}  // namespace waymark::plan
