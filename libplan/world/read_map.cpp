// One pass over the document checks shapes and hands nodes and edges to Hallways, which checks geometry; either fault
// is reported where it stands. Keys we do not know are left alone (maps may carry notes of their own) unless one looks
// like a slip of a key of ours: that is the typing error that would otherwise lose an object without a word.
#include "libplan/world/read_map.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using json = JsonReader::Value;
constexpr std::size_t most_map_bytes = std::size_t{1} << 26U;  // 64 MiB

class MapReader {
 public:
  MapReader(std::string_view text, std::string_view source) : in_(text, source) {}

  Map read() {
    const json document = in_.parse();
    if (!document.is_object()) in_.fail("", "expected an object with \"name\", \"nodes\" and \"edges\"");
    in_.check_keys(document, "", {"name", "headings", "objects", "floors", "walls", "nodes", "edges"});
    if (document.contains("headings")) check_headings(document["headings"]);
    Hallways hallways;
    in_.each(document, "", "nodes", [&](const json& value, const std::string& path) {
      in_.at(path, [&] { hallways.add_node(node(value, path)); });
    });
    in_.each(document, "", "edges", [&](const json& value, const std::string& path) {
      Edge next = edge(value, path, hallways);
      in_.at(path, [&] { hallways.add_edge(std::move(next)); });
    });
    if (hallways.nodes().empty()) in_.fail("nodes", "a map needs at least one node");
    std::string name = document.contains("name") ? in_.string(document["name"], "name") : "";
    std::vector<std::string> objects = values(document, "objects", objects_);
    std::vector<std::string> floors = values(document, "floors", floors_);
    std::vector<std::string> walls = values(document, "walls", walls_);
    std::optional<Map> map;
    in_.at("", [&] {
      map.emplace(std::move(name), std::move(hallways), std::move(objects), std::move(floors), std::move(walls));
    });
    return std::move(*map);
  }

 private:
  // A value used in the map and where it was first used, to name the place of one that the map does not list.
  using Used = std::map<std::string, std::string>;

  void check_headings(const json& headings) const {
    const json ours = {{"0", {0, -1}}, {"90", {1, 0}}, {"180", {0, 1}}, {"270", {-1, 0}}};
    if (headings != ours)
      in_.fail("headings", R"(must be {"0": [0,-1], "90": [1,0], "180": [0,1], "270": [-1,0]}: y grows downwards)");
  }

  Node node(const json& value, const std::string& path) {
    if (!value.is_object()) in_.fail(path, R"(expected a node like {"x": 1, "y": 6})");
    in_.check_keys(value, path, {"x", "y", "object", "place"});
    Node node;
    for (const char* key : {"x", "y"})
      if (!value.contains(key)) in_.fail(path, "the key \"" + std::string(key) + "\" is missing");
    node.x = in_.integer(value["x"], path + ".x");
    node.y = in_.integer(value["y"], path + ".y");
    if (value.contains("place") && !value["place"].is_null()) node.place = in_.integer(value["place"], path + ".place");
    if (const std::string name = optional_name(value, "object", path, objects_); !name.empty()) node.object = name;
    return node;
  }

  Edge edge(const json& value, const std::string& path, const Hallways& hallways) {
    if (!value.is_object()) in_.fail(path, R"(expected an edge like {"a": [0,5], "b": [0,6], "floor": "blue"})");
    in_.check_keys(value, path, {"a", "b", "floor", "wall"});
    Edge edge;
    edge.a = end(value, "a", path, hallways);
    edge.b = end(value, "b", path, hallways);
    edge.floor = optional_name(value, "floor", path, floors_);
    edge.wall = optional_name(value, "wall", path, walls_);
    return edge;
  }

  std::uint32_t end(const json& edge, const std::string& key, const std::string& path, const Hallways& hallways) const {
    if (!edge.contains(key)) in_.fail(path, "the key \"" + key + "\" is missing");
    const std::string here = path + "." + key;
    const json& value = edge[key];
    if (!value.is_array() || value.size() != 2) in_.fail(here, "expected a place [x,y]");
    const int x = in_.integer(value[0], here + "[0]"), y = in_.integer(value[1], here + "[1]");
    const auto node = hallways.node_at(x, y);
    if (!node) in_.fail(here, "there is no node at (" + std::to_string(x) + "," + std::to_string(y) + ")");
    return *node;
  }

  // The text under `key`, "" when missing or null; remembered in `used`.
  std::string optional_name(const json& object, const std::string& key, const std::string& path, Used& used) const {
    if (!object.contains(key) || object[key].is_null()) return "";
    const std::string here = path + "." + key;
    std::string name = in_.string(object[key], here);
    if (name.empty()) in_.fail(here, "expected a name, or null for none");
    used.try_emplace(name, here);
    return name;
  }

  // The list under `key`, which must hold every value used; without one, the values used, sorted.
  std::vector<std::string> values(const json& document, const std::string& key, const Used& used) const {
    std::vector<std::string> listed;
    if (!document.contains(key)) {
      for (const auto& [name, path] : used) listed.push_back(name);
      return listed;
    }
    in_.each(document, "", key,
             [&](const json& value, const std::string& path) { listed.push_back(in_.string(value, path)); });
    for (const auto& [name, path] : used)
      if (std::find(listed.begin(), listed.end(), name) == listed.end())
        in_.fail(path, "\"" + name + "\" is not among \"" + key + "\"");
    return listed;
  }

  const JsonReader in_;
  Used objects_, floors_, walls_;
};

}  // namespace

Map parse_map(std::string_view json_text, std::string_view source) { return MapReader(json_text, source).read(); }

std::vector<std::string> shipped_maps(const std::filesystem::path& data) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(data / "maps", error))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Map read_map(const std::string& name_or_file, const std::filesystem::path& data) {
  const std::vector<std::string> names = shipped_maps(data);
  if (std::find(names.begin(), names.end(), name_or_file) != names.end()) {
    const std::filesystem::path file = data / "maps" / (name_or_file + ".json");
    return parse_map(ltl::read_text(file, most_map_bytes), file.string());
  }
  std::error_code error;
  if (std::filesystem::exists(name_or_file, error))
    return parse_map(ltl::read_text(name_or_file, most_map_bytes), name_or_file);
  std::string message = "unknown map '" + name_or_file + "': no such file, and no such map";
  if (const auto meant = ltl::Vocabulary(names).nearest(name_or_file)) message += " (did you mean '" + *meant + "'?)";
  message += names.empty() ? "; no maps in " + (data / "maps").string() : "; the maps are";
  for (std::size_t i = 0; i < names.size(); ++i) message += (i == 0 ? " " : ", ") + names[i];
  throw ltl::FormatError("", 0, 0, message);
}

}  // namespace waymark::plan
