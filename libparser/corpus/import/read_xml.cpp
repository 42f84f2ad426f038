#include "libparser/corpus/import/read_xml.hpp"

#include <algorithm>
#include <charconv>
#include <pugixml.hpp>
#include <set>
#include <stdexcept>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

class Xml {  // a document that knows the lines of its nodes
 public:
  Xml(std::string_view text, std::string_view file) : file_(file) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') newlines_.push_back(static_cast<std::ptrdiff_t>(i));
    const pugi::xml_parse_result result =  // blanks beside comments and elements belong to the text
        document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata,
                              pugi::encoding_utf8);
    if (!result)
      throw ltl::FormatError(file, line_of(result.offset), 0, std::string("malformed XML: ") + result.description());
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
    const pugi::xml_node root = document_.root();
    for (pugi::xml_node node = after(root, root); node; node = after(node, root))
      if (node.name() == name) found.push_back(node);
    return found;
  }
  static std::string text(const pugi::xml_node& root) {  // all of it, whatever stands between
    std::string out;
    for (pugi::xml_node node = after(root, root); node; node = after(node, root)) out += node.value();
    return out;
  }

 private:
  // The next below root in the order of the file, without recursion: files nest as deep as they like. Null: none.
  static pugi::xml_node after(pugi::xml_node node, const pugi::xml_node& root) {
    if (const pugi::xml_node child = node.first_child()) return child;
    while (node != root && !node.next_sibling()) node = node.parent();
    return node == root ? pugi::xml_node() : node.next_sibling();
  }
  std::size_t line_of(std::ptrdiff_t offset) const {
    if (offset < 0) return 0;
    const auto before = std::lower_bound(newlines_.begin(), newlines_.end(), offset);
    return 1 + static_cast<std::size_t>(before - newlines_.begin());
  }

  std::string_view file_;
  std::vector<std::ptrdiff_t> newlines_;  // where they stand
  pugi::xml_document document_;
};

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
  MapReader(std::string_view xml, std::string_view file) : in_(xml, file) { map_.file = file; }

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

  Xml in_;
  ReleasedMap map_;
  plan::Hallways hallways_;  // says what is wrong with a node or an edge
  std::set<std::string> objects_, floors_, walls_;
};

std::optional<plan::Pose> place(const Xml& in, const pugi::xml_node& node, const char* name, std::string_view file) {
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
    example.text = squeezed(Xml::text(instruction));
    example.path = parse_pose_list(Xml::text(path), file, in.line(path));
    example.start = place(in, node, "start", file);
    example.end = place(in, node, "end", file);
    examples.push_back(std::move(example));
  }
  if (examples.empty()) throw ltl::FormatError(file, 0, 0, "holds no <example>");
  return examples;
}

}  // namespace waymark::parser
