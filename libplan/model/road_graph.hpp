// Streets of a whole country: a deterministic model with labels on nodes and whole costs, stored in compressed rows.
//
// A state is a node, a choice an arc; its letter is that of the node it leads to, as everywhere (docs/conventions.md
// 1). A node takes six bytes and an arc eight, so that 10⁷ nodes of streets (2.2 arcs each) take 0.24 GB. Costs are
// whole numbers, so sums are exact.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/mdp.hpp"
#include "libplan/world/letters.hpp"

namespace waymark::plan {

class RoadGraph {
 public:
  struct Arc {               // a piece of road, in one direction
    std::uint32_t to = 0;    // a node
    std::uint32_t cost = 0;  // in the unit of the file
  };
  struct Parts {                        // what a graph is made of
    std::vector<std::uint32_t> tails;   // by arc, in any order
    std::vector<Arc> arcs;              // as many
    Letters letters;                    // letter 0 is empty
    std::vector<std::uint16_t> letter;  // by node
    std::uint32_t start = 0;            // where runs begin
  };
  static constexpr std::size_t most_nodes = std::size_t{1} << 30U;    // of a graph
  static constexpr std::uint32_t most_arc_cost = UINT32_MAX / 2;      // of one arc
  static constexpr std::size_t most_letters = std::size_t{1} << 16U;  // different ones

  // Arcs of a node keep their order. O(nodes + arcs); sorted tails are not copied. Throws std::invalid_argument: an
  // end that is no node, a cost above most_arc_cost, no node, a first letter that is not empty.
  explicit RoadGraph(Parts parts);

  std::size_t nodes() const { return letter_.size(); }   // at least one
  std::size_t arcs() const { return arcs_.size() - 1; }  // directed
  std::span<const Arc> arcs(std::uint32_t node) const {  // that leave the node
    return {arcs_.data() + first_[node], arcs_.data() + first_[node + 1]};
  }
  LetterId letter(std::uint32_t node) const { return {letter_[node]}; }             // of the node
  const Letters& letters() const { return letters_; }                               // that nodes have
  std::uint32_t start() const { return start_; }                                    // where runs begin
  static std::string name(std::uint32_t node) { return std::to_string(node + 1); }  // as files number nodes, from 1

  // The nodes of a letter that is not empty, ascending.
  std::span<const std::uint32_t> nodes_of(LetterId letter) const { return nodes_of_[letter.index]; }
  // Those of them that an arc from a node of another letter leads to: where an area is entered.
  std::span<const std::uint32_t> entrances_of(LetterId letter) const { return entrances_of_[letter.index]; }
  std::size_t count(LetterId letter) const;  // of nodes with the letter, also the empty one

  // Of all but the start, for files made from this graph. O(nodes + arcs).
  std::uint64_t checksum() const;

 private:
  void sort(std::vector<std::uint32_t> tails);
  std::vector<std::uint32_t> first_;  // by node; one more entry, for the end
  std::vector<Arc> arcs_;             // one more entry, never read, so that the end of a row has an address
  std::vector<std::uint16_t> letter_;
  Letters letters_;
  std::vector<std::vector<std::uint32_t>> nodes_of_, entrances_of_;  // by letter
  std::uint32_t start_ = 0;
};

// The same model for solvers that take any Mdp: choices are called after the node they lead to.
Mdp model_of(const RoadGraph& graph);

}  // namespace waymark::plan
