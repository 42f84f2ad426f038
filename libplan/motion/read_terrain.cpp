#include "libplan/motion/read_terrain.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "libplan/world/json_position.hpp"

namespace waymark::plan {
namespace {

using nlohmann::json;

class TerrainReader {
 public:
  TerrainReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  Terrain read() const {
    const json document = parse();
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
      fail(message.substr(0, colon), message.substr(colon + 2));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw format_error(source_, text_, path, message);
  }

  json parse() const {
    try {
      return json::parse(text_.begin(), text_.end());
    } catch (const json::parse_error& error) {
      throw format_error_at(source_, text_, error.byte > 0 ? error.byte - 1 : 0, "malformed JSON");
    } catch (const json::out_of_range&) {
      throw ltl::FormatError(source_, 0, 0, "a number of the JSON text is out of range");
    }
  }

  const json& member(const json& value, const char* key, const std::string& path) const {
    if (!value.is_object() || !value.contains(key))
      fail(path, "expected an object with the key \"" + std::string(key) + "\"");
    return value[key];
  }

  const json& list(const json& value, const std::string& path) const {
    if (!value.is_array()) fail(path, "expected a list");
    return value;
  }

  std::string text(const json& value, const std::string& path) const {
    if (!value.is_string() || value.get<std::string>().empty()) fail(path, "expected a name");
    return value.get<std::string>();
  }

  Polygon polygon(const json& value, const std::string& path) const {
    Polygon out;
    for (std::size_t i = 0; i < list(value, path).size(); ++i) {
      const json& point = value[i];
      const std::string here = path + "[" + std::to_string(i) + "]";
      if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
        fail(here, "expected a point [x,y]");
      out.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    return out;
  }

  std::string_view text_, source_;
};

}  // namespace

Terrain parse_terrain(std::string_view json, std::string_view source) {
  return TerrainReader(json, source).read();
}

}  // namespace waymark::plan
