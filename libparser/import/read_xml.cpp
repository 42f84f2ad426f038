#include "libparser/import/read_xml.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

class Xml {  // a document that knows the lines of its nodes
 public:
  Xml(std::string_view text, std::string_view file) : text_(text), file_(file) {
    const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
    if (!result)
      throw ltl::FormatError(file, line_of(result.offset), 0,
                             std::string("malformed XML: ") + result.description());
  }

  std::size_t line(const pugi::xml_node& node) const { return line_of(node.offset_debug()); }

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const {
    throw ltl::FormatError(file_, line(node), 0, message);
  }
  std::string attribute(const pugi::xml_node& node, const char* name) const {
    const pugi::xml_attribute value = node.attribute(name);
    if (!value) fail(node, "<" + std::string(node.name()) + "> has no attribute " + name);
    return value.value();
  }
  int integer(const pugi::xml_node& node, const char* name) const {
    const std::string text = attribute(node, name);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail(node, std::string(name) + ": expected a whole number");
    return value;
  }
  std::vector<pugi::xml_node> all(const std::string& name) const {  // at any depth, in the order of the file
    std::vector<pugi::xml_node> found;
    collect(document_, name, found);
    return found;
  }

 private:
  static void collect(const pugi::xml_node& node, const std::string& name,
                      std::vector<pugi::xml_node>& found) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.name() == name) found.push_back(child);
      collect(child, name, found);
    }
  }
  std::size_t line_of(std::ptrdiff_t offset) const {
    if (offset < 0) return 0;
    const auto end = text_.begin() + std::min<std::ptrdiff_t>(offset, std::ssize(text_));
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), end, '\n'));
  }

  std::string_view text_, file_;
  pugi::xml_document document_;
};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

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

std::vector<std::string> sorted(const std::set<std::string>& values) {
  return {values.begin(), values.end()};
}

class MapReader {
 public:
  MapReader(std::string_view xml, std::string_view file) : in_(xml, file) { map_.file = file; }

  ReleasedMap read() {
    const auto roots = in_.all("map");
    if (roots.empty()) in_.fail({}, "expected a <map>");
    map_.name = lower(in_.attribute(roots[0], "name"));
    for (const pugi::xml_node& node : in_.all("node")) add_node(node);
    for (const pugi::xml_node& edge : in_.all("edge")) add_edge(edge);
    if (map_.nodes.empty()) in_.fail(roots[0], "a map without nodes");
    map_.objects = sorted(objects_), map_.floors = sorted(floors_), map_.walls = sorted(walls_);
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
    const auto index = static_cast<std::uint32_t>(map_.nodes.size());
    if (!index_.try_emplace({read.x, read.y}, index).second) in_.fail(node, "two nodes stand at this place");
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
    if (std::from_chars(second, last, y).ec != std::errc())
      in_.fail(edge, std::string(name) + ": expected x,y");
    const auto at = index_.find({x, y});
    if (at == index_.end()) in_.fail(edge, std::string(name) + ": there is no node at " + text);
    return at->second;
  }

  void add_edge(const pugi::xml_node& edge) {
    plan::Edge read{end(edge, "node1"), end(edge, "node2"), in_.attribute(edge, "floor"),
                    in_.attribute(edge, "wall")};
    floors_.insert(read.floor);
    walls_.insert(read.wall);
    map_.edges.push_back(std::move(read));
  }

  Xml in_;
  ReleasedMap map_;
  std::map<std::pair<int, int>, std::uint32_t> index_;
  std::set<std::string> objects_, floors_, walls_;
};

std::optional<plan::Pose> place(const Xml& in, const pugi::xml_node& node, const char* name) {
  const pugi::xml_attribute value = node.attribute(name);
  if (!value) return std::nullopt;
  const std::string text = value.value();
  const std::size_t close = text.find(')');
  if (close == std::string::npos) in.fail(node, std::string(name) + ": expected (x, y)");
  const std::string pose = "[" + text.substr(0, close) + ", 0)]";
  return parse_pose_list(pose, std::string(name) + "=\"" + text + "\"", in.line(node)).front();
}

}  // namespace

ReleasedMap parse_xml_map(std::string_view xml, std::string_view file) { return MapReader(xml, file).read(); }

std::vector<XmlExample> parse_xml_examples(std::string_view xml, std::string_view file) {
  const Xml in(xml, file);
  std::vector<XmlExample> examples;
  for (const pugi::xml_node& node : in.all("example")) {
    XmlExample example;
    example.id = in.attribute(node, "id");
    example.map = lower(in.attribute(node, "map"));
    example.line = in.line(node);
    const pugi::xml_node instruction = node.child("instruction"), path = node.child("path");
    if (!instruction || !path) in.fail(node, "expected an <instruction> and a <path> in this example");
    example.file_name = in.attribute(instruction, "filename");
    example.text = squeezed(instruction.child_value());
    example.path = parse_pose_list(path.child_value(), file, in.line(path));
    example.start = place(in, node, "start");
    example.end = place(in, node, "end");
    examples.push_back(std::move(example));
  }
  return examples;
}

}  // namespace waymark::parser
