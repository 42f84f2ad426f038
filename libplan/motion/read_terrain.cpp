#include "libplan/motion/read_terrain.hpp"

#include <stdexcept>
#include <string>

#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using json = JsonReader::Value;

class TerrainReader {
 public:
  TerrainReader(std::string_view text, std::string_view source) : in_(text, source) {}

  Terrain read() const {
    const json document = in_.parse();
    Polygon border = polygon(member(document, "boundary", ""), "boundary");
    std::vector<Polygon> obstacles;
    if (document.contains("obstacles"))
      for (std::size_t i = 0; i < list(document["obstacles"], "obstacles").size(); ++i)
        obstacles.push_back(polygon(document["obstacles"][i], "obstacles[" + std::to_string(i) + "]"));
    std::vector<NamedRegion> regions;
    const json& named = list(member(document, "regions", ""), "regions");
    for (std::size_t i = 0; i < named.size(); ++i) {
      const std::string path = "regions[" + std::to_string(i) + "]";
      regions.push_back({text(member(named[i], "name", path), path + ".name"),
                         polygon(member(named[i], "polygon", path), path + ".polygon")});
    }
    const std::string name = document.contains("name") ? text(document["name"], "name") : "terrain";
    try {
      return Terrain(name, std::move(border), std::move(obstacles), std::move(regions));
    } catch (const std::invalid_argument& error) {  // "obstacles[2]: the polygon meets itself"
      const std::string message = error.what();
      const std::size_t colon = message.find(": ");
      in_.fail(message.substr(0, colon), message.substr(colon + 2));
    }
  }

 private:
  const json& member(const json& value, const char* key, const std::string& path) const {
    if (!value.is_object() || !value.contains(key))
      in_.fail(path, "expected an object with the key \"" + std::string(key) + "\"");
    return value[key];
  }

  const json& list(const json& value, const std::string& path) const {
    if (!value.is_array()) in_.fail(path, "expected a list");
    return value;
  }

  std::string text(const json& value, const std::string& path) const {
    if (!value.is_string() || value.get<std::string>().empty()) in_.fail(path, "expected a name");
    return value.get<std::string>();
  }

  Polygon polygon(const json& value, const std::string& path) const {
    Polygon out;
    for (std::size_t i = 0; i < list(value, path).size(); ++i) {
      const json& point = value[i];
      const std::string here = path + "[" + std::to_string(i) + "]";
      if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
        in_.fail(here, "expected a point [x,y]");
      out.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    return out;
  }

  const JsonReader in_;
};

}  // namespace

Terrain parse_terrain(std::string_view json, std::string_view source) { return TerrainReader(json, source).read(); }

}  // namespace waymark::plan
