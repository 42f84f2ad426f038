#include "tools/product_picture.hpp"

#include <algorithm>
#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include "tools/answer.hpp"
#include "tools/picture.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

constexpr const char* look =
    "  fontname=\"Helvetica\"; fontsize=12;\n"
    "  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=11];\n"
    "  edge [fontname=\"Helvetica\", fontsize=10, arrowsize=0.7];\n";

std::string in_quotes(const std::string& text) { return Json(text).text(); }

// "FORWARD, LEFT": no label twice.
std::string joined(std::vector<std::string> labels) {
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  std::string out;
  for (const std::string& label : labels) out += (out.empty() ? "" : ", ") + label;
  return out;
}

}  // namespace

void ProductPicture::add_state(std::string name, std::uint32_t task, bool goal, bool trap) {
  tasks_[task].push_back(states_.size());
  states_.push_back({std::move(name), task, goal, trap});
}

void ProductPicture::add_edge(std::size_t from, std::size_t to, std::string label) {
  edges_.push_back({from, to, std::move(label)});
}

std::size_t ProductPicture::drawn_nodes() const { return by_task() ? tasks_.size() : states_.size(); }

std::string ProductPicture::dot() const { return by_task() ? dot_of_tasks() : dot_of_states(); }

std::string ProductPicture::dot_of_states() const {
  std::string out = "digraph product {\n" + std::string(look);
  for (const auto& [task, members] : tasks_) {
    out += "  subgraph cluster_" + std::to_string(task) + " {\n    label=\"task " + std::to_string(task) +
           "\"; color=gray60; style=rounded;\n";
    for (const std::size_t s : members)
      out += "    " + std::to_string(s) + " [label=" + in_quotes(states_[s].name) +
             (states_[s].goal ? ", peripheries=2" : "") + (states_[s].trap ? ", color=gray70, fontcolor=gray50" : "") +
             "];\n";
    out += "  }\n";
  }
  for (std::size_t i = 0; i < starts_.size(); ++i)
    out += "  start" + std::to_string(i) + " [shape=point]; start" + std::to_string(i) + " -> " +
           std::to_string(starts_[i]) + ";\n";
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> labels;
  for (const Edge& edge : edges_) labels[{edge.from, edge.to}].push_back(edge.label);
  for (const auto& [ends, all] : labels)
    out += "  " + std::to_string(ends.first) + " -> " + std::to_string(ends.second) +
           " [label=" + in_quotes(joined(all)) + "];\n";
  return out + "}\n";
}

std::string ProductPicture::dot_of_tasks() const {
  std::string out = "digraph product {\n" + std::string(look) +
                    "  labelloc=b; label=\"one node for each state of the automaton, with the places that go with "
                    "it\";\n";
  for (const auto& entry : tasks_) {
    const std::uint32_t task = entry.first;
    const std::vector<std::size_t>& members = entry.second;
    const auto count = [&](bool State::*which) {
      return static_cast<std::size_t>(
          std::count_if(members.begin(), members.end(), [&](std::size_t s) { return states_[s].*which; }));
    };
    const std::size_t goals = count(&State::goal), traps = count(&State::trap);
    std::string label = "task " + std::to_string(task) + "\n" + counted(members.size(), "place");
    if (goals > 0) label += "\n" + counted(goals, "goal");
    out += "  t" + std::to_string(task) + " [label=" + in_quotes(label) + (goals > 0 ? ", peripheries=2" : "") +
           (traps == members.size() ? ", color=gray70, fontcolor=gray50" : "") + "];\n";
  }
  std::map<std::uint32_t, std::size_t> starts;
  for (const std::size_t s : starts_) ++starts[states_[s].task];
  for (const auto& [task, number] : starts)
    out += "  start" + std::to_string(task) + " [shape=point]; start" + std::to_string(task) + " -> t" +
           std::to_string(task) + (number > 1 ? " [label=\"" + counted(number, "start") + "\"]" : "") + ";\n";
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> edges;
  for (const Edge& edge : edges_) ++edges[{states_[edge.from].task, states_[edge.to].task}];
  for (const auto& [ends, number] : edges)
    out += "  t" + std::to_string(ends.first) + " -> t" + std::to_string(ends.second) + " [label=\"" +
           counted(number, "edge") + "\"];\n";
  return out + "}\n";
}

ProductPicture picture_of(const plan::MapProduct& product) {
  ProductPicture picture;
  for (const plan::ProductState& v : boost::make_iterator_range(vertices(product)))
    picture.add_state(product.model().name(v.place), v.task, product.is_accepting(v), product.is_trap(v));
  for (const plan::ProductState& v : product.starts()) picture.add_start(product.index(v));
  for (const plan::ProductState& v : boost::make_iterator_range(vertices(product)))
    for (auto [e, end] = out_edges(v, product); e != end; ++e)
      picture.add_edge(product.index(v), product.index(e->to), std::string(plan::name(product.action(*e))));
  return picture;
}

std::string product_svg(const ProductPicture& picture, const std::stop_token& stop) {
  if (picture.drawn_nodes() > most_drawn_states)
    throw GaveUp("not drawn: the automaton has more than " + counted(most_drawn_states, "state") +
                 "; --format dot gives the graph as text");
  return graph_picture(picture.dot(), stop);
}

void draw_product(const ProductPicture& picture, const std::string& path, const std::stop_token& stop) {
  write_file(path, product_svg(picture, stop));
}

}  // namespace waymark::tools
