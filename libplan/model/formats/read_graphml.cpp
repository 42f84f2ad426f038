#include "libplan/model/formats/read_graphml.hpp"

#include <initializer_list>
#include <map>
#include <string>
#include <unordered_map>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/road_network.hpp"
#include "libplan/model/formats/xml_document.hpp"
#include "libplan/world/street_map.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t most_nodes = 10'000'000;

class GraphmlReader {
 public:
  GraphmlReader(std::string_view xml, std::string_view source) : xml_(xml, source) {}

  RoadNetwork read() {
    const pugi::xml_node root = xml_.root("graphml"), graph = root.child("graph");
    if (!graph) xml_.fail(root, "expected a <graph>");
    for (const pugi::xml_node& key : root.children("key")) add_key(key);
    for (const pugi::xml_node& node : graph.children("node")) add_node(node);
    if (const pugi::xml_node hyper = graph.child("hyperedge")) xml_.fail(hyper, "hyperedges are not read");
    const bool directed = xml_.attribute(graph, "edgedefault") == "directed";
    for (const pugi::xml_node& edge : graph.children("edge")) add_edge(edge, directed);
    return std::move(network_);
  }

 private:
  struct Key {
    std::string name, fallback;
  };

  void add_key(const pugi::xml_node& key) {
    const std::string scope = key.attribute("for").value();  // "all" without one
    for (const char* element : {"node", "edge"})
      if (scope == element || scope == "all" || scope.empty())
        keys_[element][xml_.attribute(key, "id")] = {key.attribute("attr.name").value(),
                                                     key.child("default").text().get()};
  }

  // The first of the names that the element has data or a default for; "" without.
  std::string data(const pugi::xml_node& element, std::initializer_list<const char*> names) const {
    const auto found = keys_.find(element.name());
    if (found == keys_.end()) return "";
    for (const char* name : names)
      for (const auto& [id, key] : found->second) {
        if (key.name != name) continue;
        const pugi::xml_node given = element.find_child_by_attribute("data", "key", id.c_str());
        if (std::string text = given ? given.text().get() : key.fallback; !text.empty()) return text;
      }
    return "";
  }

  void add_node(const pugi::xml_node& node) {
    if (node.child("graph")) xml_.fail(node, "graphs in graphs are not read");
    const std::string id = xml_.attribute(node, "id");
    if (!numbers_.emplace(id, static_cast<std::uint32_t>(network_.nodes.size())).second)
      xml_.fail(node, "two nodes have the id '" + id + "'");
    if (network_.nodes.size() == most_nodes) xml_.fail(node, "expected at most 10,000,000 nodes");
    network_.nodes.push_back({id, {}, {}});
    if (std::string name = landmark_name(data(node, {"name", "label", "landmark"})); !name.empty())
      network_.nodes.back().landmarks.push_back(std::move(name));
  }

  std::uint32_t end(const pugi::xml_node& edge, const char* which) const {
    const auto found = numbers_.find(xml_.attribute(edge, which));
    if (found == numbers_.end()) xml_.fail(edge, std::string(which) + ": there is no node with that id");
    return found->second;
  }

  void add_edge(const pugi::xml_node& edge, bool directed) {
    const std::uint32_t a = end(edge, "source"), b = end(edge, "target");
    const std::string text = data(edge, {"length", "metres", "weight", "cost"});
    const double cost = text.empty() ? 1 : xml_.number(edge, text);
    if (!(cost >= 0 && cost <= most_cost)) xml_.fail(edge, "expected a cost from 0 to 1e100");
    network_.nodes[a].roads.push_back({b, cost});
    const std::string own = edge.attribute("directed").value();
    if (a != b && (own.empty() ? !directed : own == "false")) network_.nodes[b].roads.push_back({a, cost});
  }

  XmlDocument xml_;
  std::map<std::string, std::map<std::string, Key>> keys_;  // of nodes and edges, by id
  std::unordered_map<std::string, std::uint32_t> numbers_;  // of nodes, by id
  RoadNetwork network_;
};

}  // namespace

Mdp parse_graphml(std::string_view xml, std::string_view source, std::string_view start) {
  if (xml.size() > most_road_bytes) throw ltl::FormatError(source, 0, 0, "expected at most 1 GiB");
  return model_of(GraphmlReader(xml, source).read(), source, start);
}

}  // namespace waymark::plan
