// A contraction hierarchy of a road graph [GSSD08] that is safe for products with an automaton.
//
// Nodes are contracted one after the other, and a shortcut between two neighbours keeps the least costs of the rest.
// While a task waits in one state, the letters on which its automaton leaves the state are barriers: routes end there,
// and none goes on. So a shortcut remembers which letters it passes over, and a witness may replace it only where the
// witness passes over no other letters, as for label restrictions in [RT10]. In every subgraph that barriers leave,
// least costs are then those of the map, for all states of all automata.
//
// Nodes of rare letters, and of letters for which no bit is left, are never contracted. They and what was not worth
// contracting are the core, which a search crosses by Dijkstra. Nodes are numbered by rank: contracted ones in order,
// then the core.
#pragma once
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string_view>
#include <vector>

#include "libplan/model/road_graph.hpp"

namespace waymark::plan {

class RoadHierarchy {
 public:
  static constexpr std::uint16_t forward = 1, backward = 2;  // bits of `ways`
  static constexpr std::uint32_t road = UINT32_MAX;          // the middle of an arc of the map

  struct Arc {                 // between a node and one of higher rank; within the core, stored at both ends
    std::uint32_t head = 0;    // the other end
    std::uint32_t cost = 0;    // the same in both directions
    std::uint32_t middle = 0;  // the node that was contracted, or `road`
    std::uint16_t passed = 0;  // number of a set of letters, those between the ends
    std::uint16_t ways = 0;    // forward: to the head; backward: from it; or both
  };
  struct Row {                 // of a rank: its arcs stand together, anywhere
    std::uint32_t begin = 0;   // number of the first
    std::uint16_t size = 0;    // arcs
    std::uint16_t letter = 0;  // LetterId of the node
  };
  struct Parts {                      // what a hierarchy is made of
    std::uint64_t map = 0;            // RoadGraph::checksum
    std::uint32_t core = 0;           // the first rank that is not contracted
    std::vector<std::uint32_t> rank;  // by node
    std::vector<Row> rows;            // by rank
    std::vector<Arc> arcs;            // by number; those of no row mean nothing
    std::vector<std::uint64_t> sets;  // by number: the letters passed, as bits; set 0 is empty
    std::vector<std::uint32_t> bits;  // by bit: the LetterId
  };
  static constexpr std::size_t most_bits = 64;  // of a set of letters

  // Throws std::invalid_argument when the parts do not fit together: ranks that are no permutation, an arc that leads
  // down, a middle that is not below both ends, an unknown set. O(nodes + arcs).
  explicit RoadHierarchy(Parts parts);

  std::size_t nodes() const { return parts_.rank.size(); }                    // of the map
  std::size_t arcs() const { return arcs_; }                                  // with shortcuts
  std::uint32_t core() const { return parts_.core; }                          // ranks from here on are the core
  std::uint64_t map() const { return parts_.map; }                            // checksum of the map it was made of
  std::uint32_t rank(std::uint32_t node) const { return parts_.rank[node]; }  // of a node of the map
  std::uint32_t node(std::uint32_t rank) const { return node_[rank]; }
  LetterId letter(std::uint32_t rank) const { return {parts_.rows[rank].letter}; }  // of its node
  // Numbers of the arcs of a rank are consecutive: begin … end − 1.
  std::uint32_t begin_arcs(std::uint32_t rank) const { return parts_.rows[rank].begin; }
  std::uint32_t end_arcs(std::uint32_t rank) const { return parts_.rows[rank].begin + parts_.rows[rank].size; }
  const Arc& arc(std::uint32_t number) const { return parts_.arcs[number]; }
  const std::vector<std::uint64_t>& sets() const { return parts_.sets; }  // by number
  const std::vector<std::uint32_t>& bits() const { return parts_.bits; }  // by bit: the LetterId

  // Appends the nodes of the map after `from` up to `to`, both ranks, that an arc between them stands for. O(nodes
  // appended · degree). Throws std::logic_error for a shortcut without halves.
  void unpack(std::uint32_t from, std::uint32_t to, const Arc& arc, std::vector<std::uint32_t>& nodes) const;

 private:
  friend void write_hierarchy(std::ostream& out, const RoadHierarchy& hierarchy);
  const Arc* way_out(std::uint32_t middle, std::uint32_t end, std::uint32_t cost, const Arc& whole) const;
  Parts parts_;
  std::vector<std::uint32_t> node_;  // by rank
  std::size_t arcs_ = 0;             // of rows
};

// Bytes, little endian: a heading, then every list with its length and XXH64 (docs/formats/roads.md).
void write_hierarchy(std::ostream& out, const RoadHierarchy& hierarchy);
// Throws ltl::FormatError: cut short, damaged, not a hierarchy, or one of another map.
RoadHierarchy read_hierarchy(std::istream& in, std::string_view source, const RoadGraph& map);

}  // namespace waymark::plan
