// Hierarchies: distances in every subgraph that barriers leave, and files that are refused.
#include "libplan/roads/road_hierarchy.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libplan/roads/contract.hpp"
#include "tests/libplan/roads/random_roads.hpp"

namespace waymark::plan {
namespace {

using testing::all_contractions;
using testing::random_roads;
using testing::show;

std::string written(const RoadHierarchy& hierarchy) {
  std::ostringstream out;
  write_hierarchy(out, hierarchy);
  return out.str();
}

RoadGraph some_roads(std::uint64_t seed) {
  ltl::Random random(seed);
  return random_roads(random, {.nodes = 30, .arcs = 70});
}

TEST(RoadHierarchy, KeepsEveryArcAndUnpacksShortcuts) {
  ltl::Random random(5);
  for (int i = 0; i < 100; ++i) {
    const RoadGraph graph = random_roads(random, {.nodes = 20, .arcs = 45});
    for (const ContractionOptions& options : all_contractions()) {
      const auto h = contract(graph, options);
      for (std::uint32_t r = 0; r < h->nodes(); ++r)
        for (std::uint32_t a = h->first_arc(r); a < h->first_arc(r + 1); ++a) {
          const RoadHierarchy::Arc& arc = h->arc(a);
          const bool up = (arc.ways & RoadHierarchy::forward) != 0;
          std::vector<std::uint32_t> nodes{h->node(up ? r : arc.head)};
          h->unpack(up ? r : arc.head, up ? arc.head : r, arc, nodes);
          std::uint64_t cost = 0, passed = 0;
          for (std::size_t n = 1; n < nodes.size(); ++n) {
            std::uint64_t least = UINT64_MAX;
            for (const RoadGraph::Arc& road : graph.arcs(nodes[n - 1]))
              if (road.to == nodes[n]) least = std::min<std::uint64_t>(least, road.cost);
            ASSERT_NE(least, UINT64_MAX) << show(graph);
            cost += least;
            for (std::size_t b = 0; b < h->bits().size() && n + 1 < nodes.size(); ++b)
              if (h->bits()[b] == graph.letter(nodes[n]).index) passed |= std::uint64_t{1} << b;
          }
          ASSERT_EQ(cost, arc.cost) << show(graph);
          ASSERT_EQ(passed & ~h->sets()[arc.passed], 0U) << show(graph);
        }
    }
  }
}

TEST(RoadHierarchy, IsWrittenAndRead) {
  const RoadGraph graph = some_roads(6);
  const auto hierarchy = contract(graph);
  const std::string bytes = written(*hierarchy);
  std::istringstream in(bytes);
  EXPECT_EQ(written(read_hierarchy(in, "roads.ch", graph)), bytes);
}

TEST(RoadHierarchy, IsRefusedWhenDamagedCutOrOfAnotherMap) {
  const RoadGraph graph = some_roads(7);
  const std::string bytes = written(*contract(graph));
  const auto refused = [&](const std::string& text, const RoadGraph& map) {
    std::istringstream in(text);
    try {
      read_hierarchy(in, "roads.ch", map);
    } catch (const ltl::FormatError&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused(bytes, graph));
  EXPECT_TRUE(refused(bytes, some_roads(8)));
  EXPECT_TRUE(refused(bytes + "x", graph));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    EXPECT_TRUE(refused(bytes.substr(0, at), graph)) << at;
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    EXPECT_TRUE(refused(damaged, graph)) << at;
  }
}

TEST(RoadHierarchy, RefusesCostsThatAddUpTooFar) {
  RoadGraph::Parts parts;
  parts.letters = Letters(ltl::Vocabulary(std::vector<std::string>{"a"}));
  parts.letters.intern({});
  parts.letter.assign(8, 0);
  for (std::uint32_t v = 0; v + 1 < 8; ++v) {
    parts.tails.push_back(v);
    parts.arcs.push_back({v + 1, RoadGraph::most_arc_cost});
  }
  EXPECT_THROW(contract(RoadGraph(std::move(parts))), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
