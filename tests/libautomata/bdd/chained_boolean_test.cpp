// Boolean functions with chained variables against their truth tables over the assignments that respect the chains.
#include "libautomata/bdd/chained_boolean.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
constexpr Mtbdd::Variable variables = 8;

// Variables 0, 2, 5 of a chain where true forces, 1, 3, 6 of one where false does; 4 and 7 are free.
struct Chained {
  Chained() : logic(diagram) {
    const auto up = logic.add_chain(true), down = logic.add_chain(false);
    for (const Mtbdd::Variable v : {0U, 2U, 5U}) logic.append(up, v);
    for (const Mtbdd::Variable v : {1U, 3U, 6U}) logic.append(down, v);
  }
  static bool respects(std::size_t bits) {
    const auto at = [&](std::size_t v) { return ((bits >> v) & 1U) != 0; };
    return (!at(0) || (at(2) && at(5))) && (!at(2) || at(5)) && (at(1) || (!at(3) && !at(6))) && (at(3) || !at(6));
  }
  Mtbdd diagram;
  ChainedBoolean logic;
};

using Table = std::vector<bool>;  // by respectful assignment
std::vector<std::size_t> respectful() {
  std::vector<std::size_t> out;
  for (std::size_t bits = 0; bits < (std::size_t{1} << variables); ++bits)
    if (Chained::respects(bits)) out.push_back(bits);
  return out;
}

// Equal functions are equal nodes, different ones different nodes, and evaluation is right: on every step of a random
// walk through functions.
TEST(ChainedBoolean, FunctionsThatAgreeOnRespectfulAssignmentsAreOneNode) {
  const std::vector<std::size_t> assignments = respectful();
  ASSERT_EQ(assignments.size(), 4U * 4U * 4U);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Chained c;
    std::mt19937_64 random(seed);
    std::vector<std::pair<Node, Table>> known;
    for (Mtbdd::Variable v = 0; v < variables; ++v) {
      Table table;
      for (const std::size_t bits : assignments) table.push_back(((bits >> v) & 1U) != 0);
      known.emplace_back(c.logic.variable(v), table);
    }
    std::map<Table, Node> node_of;
    for (int step = 0; step < 400; ++step) {
      const auto pick = [&] { return known[random() % known.size()]; };
      const auto [f, in_f] = pick();
      const auto [g, in_g] = pick();
      const auto [h, in_h] = pick();
      const Node made = c.logic.if_then_else(f, g, h);
      Table table;
      for (std::size_t i = 0; i < assignments.size(); ++i) table.push_back(in_f[i] ? in_g[i] : in_h[i]);
      for (std::size_t i = 0; i < assignments.size(); ++i) {
        const auto assignment = [&](Mtbdd::Variable v) { return ((assignments[i] >> v) & 1U) != 0; };
        ASSERT_EQ(c.diagram.evaluate(made, assignment) == ChainedBoolean::constant(true), table[i])
            << "seed " << seed << ", step " << step << ", assignment " << assignments[i];
      }
      const auto [at, fresh] = node_of.try_emplace(table, made);
      ASSERT_EQ(at->second, made) << "one function, two nodes: seed " << seed << ", step " << step;
      known.emplace_back(made, table);
    }
    std::map<Node, Table> table_of;
    for (const auto& [table, node] : node_of) ASSERT_TRUE(table_of.emplace(node, table).second) << "seed " << seed;
  }
}

TEST(ChainedBoolean, KnowsWhatFollowsAlongAChain) {
  Chained c;
  const auto v = [&](Mtbdd::Variable variable) { return c.logic.variable(variable); };
  EXPECT_TRUE(c.logic.implies(v(0), v(5)));
  EXPECT_FALSE(c.logic.implies(v(5), v(0)));
  EXPECT_TRUE(c.logic.implies(v(6), v(1)));
  EXPECT_FALSE(c.logic.implies(v(0), v(1)));
  EXPECT_EQ(c.logic.conjunction(v(0), v(2)), v(0));
  EXPECT_EQ(c.logic.disjunction(v(0), v(2)), v(2));
  EXPECT_EQ(c.logic.conjunction(v(1), v(3)), v(3));
}

TEST(ChainedBoolean, WithoutChainsIsPlain) {
  Mtbdd diagram;
  ChainedBoolean logic(diagram);
  Boolean plain(diagram);
  EXPECT_EQ(logic.conjunction(logic.variable(0), logic.variable(1)),
            plain.conjunction(plain.variable(0), plain.variable(1)));
}

}  // namespace
}  // namespace waymark::automata
