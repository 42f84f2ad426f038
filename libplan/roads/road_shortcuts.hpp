// The roads that remain while nodes are contracted one after the other: every arc is kept at both of its ends.
//
// Between two nodes there may be several arcs, none of them both as cheap as another one and past no other letters: the
// rest is dominated and dropped, as labels are in searches with several criteria. The row of a contracted node stays as
// it was when it was contracted: its arcs to nodes of higher rank.
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libplan/model/road_graph.hpp"
#include "libplan/roads/road_hierarchy.hpp"

namespace waymark::plan {

// Sets of up to 64 letters by number; equal sets have one number. Throws std::invalid_argument past 2^16 of them.
class LetterSets {
 public:
  LetterSets() : sets_{0}, numbers_{{0, 0}} {}
  std::uint16_t number(std::uint64_t set) { return set == 0 ? 0 : known(set); }  // new or not
  std::uint64_t operator[](std::uint16_t n) const { return sets_[n]; }
  bool contains(std::uint16_t whole, std::uint16_t part) const {  // every letter of the part?
    return part == 0 || part == whole || (sets_[part] & ~sets_[whole]) == 0;
  }
  const std::vector<std::uint64_t>& all() const { return sets_; }  // by number

 private:
  std::uint16_t known(std::uint64_t set);
  std::vector<std::uint64_t> sets_;
  std::unordered_map<std::uint64_t, std::uint16_t> numbers_;
};

class RemainingRoads {  // the arcs between nodes that are not contracted yet
 public:
  using Arc = RoadHierarchy::Arc;  // heads and middles are nodes here, not ranks

  // Loops are left out, and of several equal arcs all but one. O(arcs · degree).
  RemainingRoads() = default;  // of no nodes
  explicit RemainingRoads(const RoadGraph& graph);

  LetterSets& sets() { return sets_; }  // of the letters that arcs pass over
  // Those that are left, or were left when the node was contracted.
  std::span<const Arc> arcs(std::uint32_t node) const { return {pool_.data() + rows_[node].begin, rows_[node].size}; }
  // An arc from u to w, along `arc.ways`, with arc.head = w; nothing where it is dominated. O(degree).
  void add(std::uint32_t u, const Arc& arc);
  std::uint32_t begin(std::uint32_t node) const { return rows_[node].begin; }  // of its row among all arcs
  std::vector<Arc> take_arcs() { return std::move(pool_); }                    // those of rows, and some of none
  // Takes a node out of its neighbours' rows; its own stays. O(sum of their degrees).
  void detach(std::uint32_t node);

 private:
  struct Row {
    std::uint32_t begin = 0;
    std::uint16_t size = 0, capacity = 0;
  };
  static constexpr std::uint16_t most_degree = UINT16_MAX / 2;
  void append(std::uint32_t node, const Arc& arc);
  void grow(Row& row);
  Arc* mirror(std::uint32_t u, const Arc& arc);
  void erase(std::uint32_t node, const Arc* arc);

  std::vector<Row> rows_;
  std::vector<Arc> pool_;
  std::vector<std::vector<std::uint32_t>> free_;  // by capacity: where such rows begin
  LetterSets sets_;
};

// Of a row of arcs seen from its other end.
inline std::uint16_t turned(std::uint16_t ways) {
  return static_cast<std::uint16_t>(((ways & RoadHierarchy::forward) << 1U) | ((ways & RoadHierarchy::backward) >> 1U));
}

}  // namespace waymark::plan
