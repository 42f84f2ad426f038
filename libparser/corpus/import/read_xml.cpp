#include "libparser/corpus/import/read_xml.hpp"

#include <charconv>
#include <set>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/xml_document.hpp"
#include "libplan/world/map.hpp"

namespace waymark::parser {
namespace {

using plan::XmlDocument;

std::string squeezed(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

std::vector<std::string> sorted(const std::set<std::string>& values) { return {values.begin(), values.end()}; }

class MapReader {
 public:
  MapReader(std::string_view xml, std::string_view file) : in_(xml, file, XmlDocument::Blanks::Kept) {
    map_.file = file;
  }

  ReleasedMap read() {
    const auto roots = in_.all("map");
    if (roots.empty()) in_.fail({}, "expected a <map>");
    map_.name = lower(in_.attribute(roots[0], "name"));
    if (map_.name.empty() || map_.name.find_first_of("/\\") != std::string::npos || map_.name[0] == '.')
      in_.fail(roots[0], "name: expected one that a file can have");
    for (const pugi::xml_node& node : in_.all("node")) add_node(node);
    for (const pugi::xml_node& edge : in_.all("edge")) add_edge(edge);
    if (map_.nodes.empty()) in_.fail(roots[0], "a map without nodes");
    map_.objects = sorted(objects_), map_.floors = sorted(floors_), map_.walls = sorted(walls_);
    checked(roots[0], [&] { const plan::Map made(map_.name, hallways_, map_.objects, map_.floors, map_.walls); });
    return std::move(map_);
  }

 private:
  void add_node(const pugi::xml_node& node) {
    plan::Node read{in_.integer(node, "x"), in_.integer(node, "y"), std::nullopt, std::nullopt};
    if (const std::string item = node.attribute("item").value(); !item.empty()) {
      objects_.insert(item);
      read.object = item;
    }
    if (node.attribute("id")) read.place = in_.integer(node, "id");
    checked(node, [&] { hallways_.add_node(read); });
    map_.nodes.push_back(std::move(read));
  }

  std::uint32_t end(const pugi::xml_node& edge, const char* name) const {
    const std::string text = in_.attribute(edge, name);
    int x = 0, y = 0;
    const char* const last = text.data() + text.size();
    const auto first = std::from_chars(text.data(), last, x);
    if (first.ec != std::errc() || first.ptr == last || *first.ptr != ',')
      in_.fail(edge, std::string(name) + ": expected x,y");
    const char* second = first.ptr + 1;
    while (second != last && *second == ' ') ++second;
    if (std::from_chars(second, last, y).ec != std::errc()) in_.fail(edge, std::string(name) + ": expected x,y");
    const auto node = hallways_.node_at(x, y);
    if (!node) in_.fail(edge, std::string(name) + ": there is no node at " + text);
    return *node;
  }

  void add_edge(const pugi::xml_node& edge) {
    plan::Edge read{end(edge, "node1"), end(edge, "node2"), in_.attribute(edge, "floor"), in_.attribute(edge, "wall")};
    checked(edge, [&] { hallways_.add_edge(read); });
    floors_.insert(read.floor);
    walls_.insert(read.wall);
    map_.edges.push_back(std::move(read));
  }

  template <typename Step>
  void checked(const pugi::xml_node& node, Step step) const {
    try {
      step();
    } catch (const std::invalid_argument& error) {
      in_.fail(node, error.what());
    }
  }

  XmlDocument in_;
  ReleasedMap map_;
  plan::Hallways hallways_;  // says what is wrong with a node or an edge
  std::set<std::string> objects_, floors_, walls_;
};

std::optional<plan::Pose> place(const XmlDocument& in, const pugi::xml_node& node, const char* name,
                                std::string_view file) {
  const pugi::xml_attribute value = node.attribute(name);
  if (!value) return std::nullopt;
  const std::string text = value.value();
  const std::size_t close = text.find(')');
  if (close == std::string::npos) in.fail(node, std::string(name) + ": expected (x, y)");
  const std::string pose = "[" + text.substr(0, close) + ", 0)]";
  return parse_pose_list(pose, file, in.line(node)).front();
}

}  // namespace

ReleasedMap parse_xml_map(std::string_view xml, std::string_view file) { return MapReader(xml, file).read(); }

std::vector<XmlExample> parse_xml_examples(std::string_view xml, std::string_view file) {
  const XmlDocument in(xml, file, XmlDocument::Blanks::Kept);
  std::vector<XmlExample> examples;
  for (const pugi::xml_node& node : in.all("example")) {
    XmlExample example;
    example.id = in.attribute(node, "id");
    example.map = lower(in.attribute(node, "map"));
    example.line = in.line(node);
    const pugi::xml_node instruction = node.child("instruction"), path = node.child("path");
    if (!instruction || !path) in.fail(node, "expected an <instruction> and a <path> in this example");
    example.file_name = in.attribute(instruction, "filename");
    example.text = squeezed(XmlDocument::text(instruction));
    example.path = parse_pose_list(XmlDocument::text(path), file, in.line(path));
    example.start = place(in, node, "start", file);
    example.end = place(in, node, "end", file);
    examples.push_back(std::move(example));
  }
  if (examples.empty()) throw ltl::FormatError(file, 0, 0, "holds no <example>");
  return examples;
}

}  // namespace waymark::parser
