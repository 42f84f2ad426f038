// The picture of a product: state by state while it is small, else one node for each state of the automaton.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libplan/product/compose.hpp"

namespace waymark::tools {

// States in the order of their numbers; of a pair (place, task) the name is that of the place.
class ProductPicture {
 public:
  void add_state(std::string name, std::uint32_t task, bool goal, bool trap);
  void add_edge(std::size_t from, std::size_t to, std::string label);
  void add_start(std::size_t state) { starts_.push_back(state); }

  // Graphviz DOT: at most `most_states` states stand one by one, in a box for each task; else a task is a node that
  // says how many places it has, and an edge between two tasks says how many edges of the product it stands for.
  static constexpr std::size_t most_states = 60;
  std::string dot() const;
  std::size_t drawn_nodes() const;  // that Graphviz has to lay out

 private:
  struct State {
    std::string name;
    std::uint32_t task;
    bool goal, trap;
  };
  struct Edge {
    std::size_t from, to;
    std::string label;
  };
  bool by_task() const { return states_.size() > most_states; }
  std::string dot_of_states() const;
  std::string dot_of_tasks() const;

  std::vector<State> states_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> starts_;
  std::map<std::uint32_t, std::vector<std::size_t>> tasks_;  // the states of each
};

// Of a map and the automaton of a task.
ProductPicture picture_of(const plan::MapProduct& product);

// Lays it out, as an SVG document; the second writes it to `path`. Throws GaveUp when there are too many nodes even by
// task.
std::string product_svg(const ProductPicture& picture, const std::stop_token& stop);
void draw_product(const ProductPicture& picture, const std::string& path, const std::stop_token& stop);

}  // namespace waymark::tools
