// One pass over the document checks shapes and hands nodes and edges to Hallways, which checks geometry; either fault
// is reported where it stands. Keys we do not know are left alone (maps may carry notes of their own) unless one looks
// like a slip of a key of ours: that is the typing error that would otherwise lose an object without a word.
#include "libplan/world/read_map.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "libplan/world/json_position.hpp"

namespace waymark::plan {
namespace {

using nlohmann::json;

class MapReader {
 public:
  MapReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  Map read() {
    const json document = parse();
    if (!document.is_object()) fail("", "expected an object with \"name\", \"nodes\" and \"edges\"");
    check_keys(document, "", {"name", "headings", "objects", "floors", "walls", "nodes", "edges"});
    if (document.contains("headings")) check_headings(document["headings"]);
    Hallways hallways;
    each(document, "nodes", [&](const json& value, const std::string& path) {
      at(path, [&] { hallways.add_node(node(value, path)); });
    });
    each(document, "edges", [&](const json& value, const std::string& path) {
      Edge next = edge(value, path, hallways);
      at(path, [&] { hallways.add_edge(std::move(next)); });
    });
    if (hallways.nodes().empty()) fail("nodes", "a map needs at least one node");
    std::string name = document.contains("name") ? string(document["name"], "name") : "";
    std::vector<std::string> objects = values(document, "objects", objects_);
    std::vector<std::string> floors = values(document, "floors", floors_);
    std::vector<std::string> walls = values(document, "walls", walls_);
    std::optional<Map> map;
    at("", [&] {
      map.emplace(std::move(name), std::move(hallways), std::move(objects), std::move(floors),
                  std::move(walls));
    });
    return std::move(*map);
  }

 private:
  // A value used in the map and where it was first used, to name the place of one that the map does not list.
  using Used = std::map<std::string, std::string>;

  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw format_error(source_, text_, path, message);
  }

  json parse() const {
    try {
      return json::parse(text_.begin(), text_.end());
    } catch (const json::parse_error& error) {
      // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error …": keep what follows the place.
      const std::string_view what = error.what();
      const std::size_t colon = what.find(": ");
      throw format_error_at(
          source_, text_, error.byte > 0 ? error.byte - 1 : 0,
          "malformed JSON: " + std::string(what.substr(colon == what.npos ? 0 : colon + 2)));
    } catch (const json::out_of_range&) {
      throw ltl::FormatError(source_, 0, 0, "a number of the JSON text is out of range");
    }
  }

  // Runs a step that checks geometry; its complaint is reported at the value it was about.
  template <typename Step>
  void at(const std::string& path, Step step) const {
    try {
      step();
    } catch (const std::invalid_argument& error) {
      fail(path, error.what());
    }
  }

  void check_keys(const json& object, const std::string& path, const std::vector<std::string>& known) const {
    const ltl::Vocabulary names(known);
    for (const auto& [key, value] : object.items()) {
      if (names.find(key)) continue;
      const auto meant = names.nearest(key);
      if (meant && !object.contains(*meant))
        fail(path, "unknown key \"" + key + "\" (did you mean \"" + *meant + "\"?)");
    }
  }

  void check_headings(const json& headings) const {
    const json ours = {{"0", {0, -1}}, {"90", {1, 0}}, {"180", {0, 1}}, {"270", {-1, 0}}};
    if (headings != ours)
      fail("headings",
           R"(must be {"0": [0,-1], "90": [1,0], "180": [0,1], "270": [-1,0]}: y grows downwards)");
  }

  template <typename Visit>
  void each(const json& document, const std::string& key, Visit visit) const {
    if (!document.contains(key)) fail("", "the key \"" + key + "\" is missing");
    const json& list = document[key];
    if (!list.is_array()) fail(key, "expected a list");
    for (std::size_t i = 0; i < list.size(); ++i) visit(list[i], key + "[" + std::to_string(i) + "]");
  }

  Node node(const json& value, const std::string& path) {
    if (!value.is_object()) fail(path, R"(expected a node like {"x": 1, "y": 6})");
    check_keys(value, path, {"x", "y", "object", "place"});
    Node node;
    for (const char* key : {"x", "y"})
      if (!value.contains(key)) fail(path, "the key \"" + std::string(key) + "\" is missing");
    node.x = integer(value["x"], path + ".x");
    node.y = integer(value["y"], path + ".y");
    if (value.contains("place") && !value["place"].is_null())
      node.place = integer(value["place"], path + ".place");
    if (const std::string name = optional_name(value, "object", path, objects_); !name.empty())
      node.object = name;
    return node;
  }

  Edge edge(const json& value, const std::string& path, const Hallways& hallways) {
    if (!value.is_object()) fail(path, R"(expected an edge like {"a": [0,5], "b": [0,6], "floor": "blue"})");
    check_keys(value, path, {"a", "b", "floor", "wall"});
    Edge edge;
    edge.a = end(value, "a", path, hallways);
    edge.b = end(value, "b", path, hallways);
    edge.floor = optional_name(value, "floor", path, floors_);
    edge.wall = optional_name(value, "wall", path, walls_);
    return edge;
  }

  std::uint32_t end(const json& edge, const std::string& key, const std::string& path,
                    const Hallways& hallways) const {
    if (!edge.contains(key)) fail(path, "the key \"" + key + "\" is missing");
    const std::string here = path + "." + key;
    const json& value = edge[key];
    if (!value.is_array() || value.size() != 2) fail(here, "expected a place [x,y]");
    const int x = integer(value[0], here + "[0]"), y = integer(value[1], here + "[1]");
    const auto node = hallways.node_at(x, y);
    if (!node) fail(here, "there is no node at (" + std::to_string(x) + "," + std::to_string(y) + ")");
    return *node;
  }

  int integer(const json& value, const std::string& path) const {
    if (!value.is_number_integer()) fail(path, "expected a whole number");
    const bool huge = value.is_number_unsigned() && value.get<std::uint64_t>() > INT32_MAX;
    const auto number = huge ? INT64_MAX : value.get<std::int64_t>();
    if (number < INT32_MIN || number > INT32_MAX) fail(path, "the number is too large");
    return static_cast<int>(number);
  }

  std::string string(const json& value, const std::string& path) const {
    if (!value.is_string()) fail(path, "expected a text");
    return value.get<std::string>();
  }

  // The text under `key`, "" when missing or null; remembered in `used`.
  std::string optional_name(const json& object, const std::string& key, const std::string& path,
                            Used& used) const {
    if (!object.contains(key) || object[key].is_null()) return "";
    const std::string here = path + "." + key;
    std::string name = string(object[key], here);
    if (name.empty()) fail(here, "expected a name, or null for none");
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
    each(document, key,
         [&](const json& value, const std::string& path) { listed.push_back(string(value, path)); });
    for (const auto& [name, path] : used)
      if (std::find(listed.begin(), listed.end(), name) == listed.end())
        fail(path, "\"" + name + "\" is not among \"" + key + "\"");
    return listed;
  }

  std::string_view text_, source_;
  Used objects_, floors_, walls_;
};

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw ltl::FormatError(file.string(), 0, 0, "is a directory, not a map");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ltl::FormatError(file.string(), 0, 0, "cannot read the file");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

Map parse_map(std::string_view json_text, std::string_view source) {
  return MapReader(json_text, source).read();
}

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
    return parse_map(read_text(file), file.string());
  }
  std::error_code error;
  if (std::filesystem::exists(name_or_file, error)) return parse_map(read_text(name_or_file), name_or_file);
  std::string message = "unknown map '" + name_or_file + "': no such file, and no such map";
  if (const auto meant = ltl::Vocabulary(names).nearest(name_or_file))
    message += " (did you mean '" + *meant + "'?)";
  message += names.empty() ? "; no maps in " + (data / "maps").string() : "; the maps are";
  for (std::size_t i = 0; i < names.size(); ++i) message += (i == 0 ? " " : ", ") + names[i];
  throw ltl::FormatError("", 0, 0, message);
}

}  // namespace waymark::plan
