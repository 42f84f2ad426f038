// Components of small graphs against who reaches whom, by one search after another that share their room.
#include "libautomata/graph/scc.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "libltl/structure/random.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

struct Digraph {
  std::vector<std::vector<std::uint32_t>> of;  // successors
  std::size_t size() const { return of.size(); }
  const std::vector<std::uint32_t>& successors(std::uint32_t v) const { return of[v]; }
};

Digraph random_digraph(ltl::Random& random) {
  Digraph out{std::vector<std::vector<std::uint32_t>>(random.below(9))};
  for (auto& successors : out.of)
    for (std::size_t k = random.below(4); k > 0; --k)
      successors.push_back(static_cast<std::uint32_t>(random.below(out.size())));
  return out;
}

std::vector<std::vector<bool>> reaches(const Digraph& graph) {  // by one edge or none, then by more
  std::vector<std::vector<bool>> out(graph.size(), std::vector<bool>(graph.size()));
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    out[v][v] = true;
    for (const std::uint32_t w : graph.of[v]) out[v][w] = true;
  }
  for (std::uint32_t by = 0; by < graph.size(); ++by)
    for (std::uint32_t v = 0; v < graph.size(); ++v)
      for (std::uint32_t w = 0; w < graph.size(); ++w) out[v][w] = out[v][w] || (out[v][by] && out[by][w]);
  return out;
}

std::string shown(const Digraph& graph) {
  std::string out;
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    out += std::to_string(v) + ":";
    for (const std::uint32_t w : graph.of[v]) out += " " + std::to_string(w);
    out += "; ";
  }
  return out;
}

TEST(Components, AreThoseThatReachEachOther) {
  ltl::Random random(91);
  ComponentSearch search;
  Components found;
  std::size_t several = 0;
  for (int i = 0; i < testing::scaled(5'000); ++i) {
    const Digraph graph = random_digraph(random);
    search.run(graph, found);
    const auto reach = reaches(graph);
    std::vector<std::uint32_t> members(found.count);
    for (std::uint32_t v = 0; v < graph.size(); ++v) {
      ASSERT_LT(found.of[v], found.count) << shown(graph);
      ++members[found.of[v]];
      for (std::uint32_t w = 0; w < graph.size(); ++w)
        ASSERT_EQ(found.of[v] == found.of[w], reach[v][w] && reach[w][v])
            << v << " and " << w << " of " << shown(graph);
      for (const std::uint32_t w : graph.of[v]) ASSERT_LE(found.of[w], found.of[v]) << shown(graph);
    }
    ASSERT_EQ(found.order.size(), graph.size()) << shown(graph);
    for (std::size_t k = 1; k < found.order.size(); ++k)
      ASSERT_LE(found.of[found.order[k - 1]], found.of[found.order[k]]) << shown(graph);
    for (const std::uint32_t v : found.order) {
      ASSERT_GT(members[found.of[v]], 0U) << "twice in the order of " << shown(graph);
      --members[found.of[v]];
    }
    several += found.count > 1 && found.count < graph.size() ? 1 : 0;
  }
  EXPECT_GT(several, static_cast<std::size_t>(testing::scaled(1'000)));
}

TEST(Components, OfALongCycleAreFoundWithoutRecursion) {
  Digraph graph{std::vector<std::vector<std::uint32_t>>(200'000)};
  for (std::uint32_t v = 0; v < graph.size(); ++v) graph.of[v] = {static_cast<std::uint32_t>((v + 1) % graph.size())};
  EXPECT_EQ(components(graph).count, 1U);
  graph.of.back().clear();
  EXPECT_EQ(components(graph).count, graph.size());
}

}  // namespace
}  // namespace waymark::automata
