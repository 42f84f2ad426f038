// Hierarchies: distances in every subgraph that barriers leave, and files that are refused.
#include "libplan/roads/road_hierarchy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libplan/roads/contract.hpp"
#include "libplan/roads/road_legs.hpp"
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
        for (std::uint32_t a = h->begin_arcs(r); a < h->end_arcs(r); ++a) {
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

// The definition of a leg, by Bellman's equation: least costs from one node past nodes that may be passed.
std::vector<std::uint64_t> leg_costs(const RoadGraph& graph, const std::vector<LegRole>& role, std::uint32_t source) {
  std::vector<std::uint64_t> cost(graph.nodes(), UINT64_MAX);
  cost[source] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t v = 0; v < graph.nodes(); ++v) {
      if (cost[v] == UINT64_MAX || !passes(role[graph.letter(v).index])) continue;
      for (const RoadGraph::Arc& arc : graph.arcs(v)) {
        if (cost[v] + arc.cost >= cost[arc.to]) continue;
        cost[arc.to] = cost[v] + arc.cost;
        changed = true;
      }
    }
  }
  return cost;
}

TEST(RoadLegs, AreTheLeastInEverySubgraphThatBarriersLeave) {
  ltl::Random random(9);
  for (int i = 0; i < 1500; ++i) {
    const auto nodes = static_cast<std::uint32_t>(6 + random.below(20));
    const RoadGraph graph = random_roads(
        random,
        {.nodes = nodes, .arcs = nodes + random.below(nodes), .labelled = 0.05 + 0.2 * random.unit(), .most_cost = 6});
    for (const ContractionOptions& options : all_contractions()) {
      const auto hierarchy = contract(graph, options);
      RoadLegs legs(graph, *hierarchy, {});
      for (int k = 0; k < 6; ++k) {
        std::vector<LegRole> role(graph.letters().size(), LegRole::Passed);
        for (std::size_t l = k == 0 ? 0 : 1; l < role.size(); ++l)
          role[l] = std::array{LegRole::Passed, LegRole::Closed, LegRole::Leads, LegRole::Either}[random.below(4)];
        const auto source = static_cast<std::uint32_t>(random.below(nodes));
        if (!passes(role[graph.letter(source).index])) continue;
        legs.begin(role);
        legs.add_source(source, 0, 0);
        ASSERT_TRUE(legs.run(UINT64_MAX));
        std::vector<std::uint64_t> found(nodes, UINT64_MAX), expected = leg_costs(graph, role, source);
        legs.for_each_reached([&](std::uint32_t node, std::uint64_t cost) { found[node] = cost; });
        for (std::uint32_t v = 0; v < nodes; ++v)
          if (leads(role[graph.letter(v).index])) {
            ASSERT_EQ(found[v], expected[v])
                << "case " << i << ", from " << RoadGraph::name(source) << " to " << RoadGraph::name(v) << '\n'
                << show(graph);
          }
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
