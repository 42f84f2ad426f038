// Colours of branches against the definition: of all assignments that agree with the edges on every cycle, one with the
// fewest colours; none where there is none.
#include "libautomata/deterministic/branch_colouring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "libltl/structure/random.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using Colours = BranchColouring::Colours;
constexpr std::uint32_t vertices = 4;

// Do some of the edges that pass, in both orders of colours, lie on one cycle with this least colour of edges and that
// of branches?
bool some_cycle(const std::vector<ProductEdge>& edges, const Colours& of_branch, std::uint32_t by_edge,
                std::uint32_t by_branch) {
  std::vector<std::vector<bool>> reach(vertices, std::vector<bool>(vertices));
  const auto passes = [&](const ProductEdge& e) { return e.colour >= by_edge && of_branch[e.branch] >= by_branch; };
  for (const ProductEdge& e : edges)
    if (passes(e)) reach[e.source][e.target] = true;
  for (std::uint32_t by = 0; by < vertices; ++by)
    for (std::uint32_t v = 0; v < vertices; ++v)
      for (std::uint32_t w = 0; w < vertices; ++w) reach[v][w] = reach[v][w] || (reach[v][by] && reach[by][w]);
  for (const ProductEdge& e : edges)
    for (const ProductEdge& f : edges)
      if (passes(e) && passes(f) && e.colour == by_edge && of_branch[f.branch] == by_branch &&
          reach[e.target][e.source] && reach[f.target][f.source] && reach[e.source][f.source] &&
          reach[f.source][e.source])
        return true;
  return false;
}

bool agree(const std::vector<ProductEdge>& edges, const Colours& of_branch, std::uint32_t colours) {
  for (std::uint32_t by_edge = 0; by_edge < 4; ++by_edge)
    for (std::uint32_t by_branch = 0; by_branch < colours; ++by_branch)
      if (by_edge % 2 != by_branch % 2 && some_cycle(edges, of_branch, by_edge, by_branch)) return false;
  return true;
}

// With so many colours, over so many branches.
bool some_agree(const std::vector<ProductEdge>& edges, std::uint32_t branches, std::uint32_t colours) {
  Colours of_branch(branches, 0);
  for (;;) {
    if (agree(edges, of_branch, colours)) return true;
    std::size_t at = 0;
    while (at < branches && ++of_branch[at] == colours) of_branch[at++] = 0;
    if (at == branches) return false;
  }
}

std::string shown(const std::vector<ProductEdge>& edges) {
  std::string out;
  for (const ProductEdge& e : edges)
    out += std::to_string(e.source) + " -" + std::to_string(e.colour) + "/" + std::to_string(e.branch) + "-> " +
           std::to_string(e.target) + "; ";
  return out;
}

TEST(BranchColouring, HasTheFewestColoursOfAllThatAgreeWithTheEdges) {
  ltl::Random random(92);
  constexpr std::uint32_t branches = 3, most = branches + 1;  // the first colour may have no branch
  BranchColouring colouring(branches, 3);
  std::size_t none = 0, some = 0, three = 0;
  for (int i = 0; i < testing::scaled(6'000); ++i) {
    std::vector<ProductEdge> edges(1 + random.below(9));
    for (ProductEdge& e : edges)
      e = {static_cast<std::uint32_t>(random.below(vertices)), static_cast<std::uint32_t>(random.below(vertices)),
           static_cast<std::uint32_t>(random.below(3)), static_cast<std::uint32_t>(random.below(branches))};
    std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.source < b.source; });
    Budget budget;
    std::vector<ProductEdge> left = edges;
    const auto found = colouring.colours(left, budget);
    if (!found) {
      ++none;
      ASSERT_FALSE(some_agree(edges, branches, most)) << shown(edges);
      ASSERT_FALSE(left.empty());
      ASSERT_FALSE(some_agree(left, branches, most)) << "what is left of " << shown(edges);
      continue;
    }
    ++some;
    std::uint32_t colours = 0;
    Colours of_branch = *found;
    for (std::uint32_t& colour : of_branch) {
      if (colour == BranchColouring::unset) colour = 0;
      colours = std::max(colours, colour + 1);
    }
    ASSERT_TRUE(agree(edges, of_branch, colours)) << shown(edges);
    ASSERT_TRUE(colours == 1 || !some_agree(edges, branches, colours - 1)) << colours << " colours of " << shown(edges);
    three += colours > 2 ? 1 : 0;
  }
  EXPECT_GT(none, static_cast<std::size_t>(testing::scaled(200)));
  EXPECT_GT(some, static_cast<std::size_t>(testing::scaled(2'000)));
  EXPECT_GT(three, static_cast<std::size_t>(testing::scaled(40)));
}

}  // namespace
}  // namespace waymark::automata
