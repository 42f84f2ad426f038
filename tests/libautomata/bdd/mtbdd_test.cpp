#include "libautomata/bdd/mtbdd.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>

#include "libautomata/bdd/boolean.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// A random diagram over `variables` variables, by the truth table: entry i is the payload under the bits of i.
Node from_table(Mtbdd& diagram, const std::vector<std::uint32_t>& table, Mtbdd::Variable variable, std::size_t base,
                Mtbdd::Variable variables) {
  if (variable == variables) return Mtbdd::terminal(table[base]);
  const Node low = from_table(diagram, table, variable + 1, base, variables);
  const Node high = from_table(diagram, table, variable + 1, base | std::size_t{1} << variable, variables);
  return diagram.make(variable, low, high);
}

std::vector<std::uint32_t> random_table(std::mt19937_64& engine, Mtbdd::Variable variables, std::uint32_t payloads) {
  std::vector<std::uint32_t> table(std::size_t{1} << variables);
  for (std::uint32_t& entry : table) entry = static_cast<std::uint32_t>(engine() % payloads);
  return table;
}

std::uint32_t value(const Mtbdd& diagram, Node n, std::size_t bits) {
  return Mtbdd::payload(diagram.evaluate(n, [&](Mtbdd::Variable v) { return ((bits >> v) & 1U) != 0; }));
}

TEST(Mtbdd, EqualFunctionsAreEqualNodes) {
  Mtbdd diagram;
  const Node x = diagram.make(0, Mtbdd::terminal(3), Mtbdd::terminal(7));
  EXPECT_EQ(diagram.make(0, Mtbdd::terminal(3), Mtbdd::terminal(7)), x);
  EXPECT_EQ(diagram.make(0, x, x), x) << "a test without effect is no node";
  EXPECT_EQ(diagram.size(), 1U);
  EXPECT_EQ(diagram.variable(x), 0U);
  EXPECT_EQ(diagram.variable(Mtbdd::terminal(3)), Mtbdd::no_variable);
}

TEST(Mtbdd, AppendedNodesAreFoundByThoseWhoMakeThem) {
  Mtbdd diagram;
  std::vector<Node> nodes;
  for (std::uint32_t i = 0; i < 1000; ++i)
    nodes.push_back(i % 3 == 0 ? diagram.make(1, Mtbdd::terminal(i), Mtbdd::terminal(i + 1))
                               : diagram.append(1, Mtbdd::terminal(i), Mtbdd::terminal(i + 1)));
  for (std::uint32_t i = 0; i < 1000; ++i)
    ASSERT_EQ(diagram.make(1, Mtbdd::terminal(i), Mtbdd::terminal(i + 1)), nodes[i]);
  EXPECT_EQ(diagram.size(), 1000U);
}

TEST(Mtbdd, EvaluatesToTheEntryOfItsTable) {
  std::mt19937_64 engine(1);
  for (Mtbdd::Variable variables = 0; variables <= 6; ++variables) {
    Mtbdd diagram;
    const std::vector<std::uint32_t> table = random_table(engine, variables, 5);
    const Node n = from_table(diagram, table, 0, 0, variables);
    for (std::size_t i = 0; i < table.size(); ++i) ASSERT_EQ(value(diagram, n, i), table[i]);
  }
}

TEST(Mtbdd, AppliesALeafOperationPointByPoint) {
  std::mt19937_64 engine(2);
  Mtbdd diagram;
  const Mtbdd::Operation sum = diagram.operation();
  const auto add = [](const std::array<Node, 2>& n) -> std::optional<Node> {
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    return Mtbdd::terminal(Mtbdd::payload(n[0]) + 10 * Mtbdd::payload(n[1]));
  };
  for (int round = 0; round < 50; ++round) {
    const auto a = random_table(engine, 7, 4), b = random_table(engine, 7, 3);
    const Node f = from_table(diagram, a, 0, 0, 7), g = from_table(diagram, b, 0, 0, 7);
    const Node h = diagram.apply(sum, std::array{f, g}, add);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(value(diagram, h, i), a[i] + 10 * b[i]);
  }
}

TEST(Mtbdd, CachedResultsSurviveGrowthAndStayApart) {
  std::mt19937_64 engine(3);
  Mtbdd diagram;
  const Mtbdd::Operation twice = diagram.operation(), thrice = diagram.operation();
  const auto times = [](std::uint32_t k) {
    return [k](const std::array<Node, 1>& n) -> std::optional<Node> {
      if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
      return Mtbdd::terminal(k * Mtbdd::payload(n[0]));
    };
  };
  const auto times2 = times(2), times3 = times(3);
  const auto table = random_table(engine, 12, 1000);
  const Node f = from_table(diagram, table, 0, 0, 12);
  for (int round = 0; round < 2; ++round) {
    const Node g = diagram.apply(twice, std::array{f}, times2), h = diagram.apply(thrice, std::array{f}, times3);
    for (std::size_t i = 0; i < table.size(); i += 7) {
      ASSERT_EQ(value(diagram, g, i), 2 * table[i]);
      ASSERT_EQ(value(diagram, h, i), 3 * table[i]);
    }
  }
}

TEST(Mtbdd, ReachableListsChildrenBeforeParentsAndNothingElse) {
  Mtbdd diagram;
  const Node low = diagram.make(2, Mtbdd::terminal(0), Mtbdd::terminal(1));
  diagram.make(2, Mtbdd::terminal(4), Mtbdd::terminal(5));  // not below the root
  const Node root = diagram.make(0, low, Mtbdd::terminal(1));
  EXPECT_EQ(diagram.reachable(std::array{root}), (std::vector<Node>{low, root}));
  EXPECT_TRUE(diagram.reachable(std::array{Mtbdd::terminal(9)}).empty());
}

TEST(Mtbdd, CollectionKeepsTheIdsOfWhatTheRootsReachAndUsesTheOthersAgain) {
  Mtbdd diagram;
  const Node low = diagram.make(2, Mtbdd::terminal(0), Mtbdd::terminal(1));
  const Node other = diagram.make(2, Mtbdd::terminal(4), Mtbdd::terminal(5));
  const Node root = diagram.make(0, low, Mtbdd::terminal(1));
  diagram.collect(std::array{root});
  EXPECT_EQ(diagram.live(), 2U);
  EXPECT_EQ(diagram.reachable(std::array{root}), (std::vector<Node>{low, root}));
  EXPECT_EQ(diagram.make(2, Mtbdd::terminal(0), Mtbdd::terminal(1)), low) << "still unique";
  const Node high = diagram.make(1, Mtbdd::terminal(7), Mtbdd::terminal(8));
  EXPECT_EQ(high, other) << "the slot of the node that was swept";
  EXPECT_EQ(diagram.size(), 3U);
  diagram.collect(std::array{low});  // now the smallest free id is that of the node below
  const Node above = diagram.make(0, diagram.make(1, Mtbdd::terminal(2), low), low);
  const std::vector<Node> order = diagram.reachable(std::array{above});
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order, (std::vector<Node>{low, diagram.low(above), above})) << "children before parents";
  diagram.collect({});
  EXPECT_EQ(diagram.live(), 0U);
}

// Parents that take the slots of older nodes have smaller ids than their children.
TEST(Mtbdd, ChildrenComeBeforeParentsInSlotsUsedAgain) {
  std::mt19937_64 engine(7);
  Mtbdd diagram;
  std::vector<Node> kept;
  std::size_t turned_round = 0;
  for (int round = 0; round < 30; ++round) {
    for (int i = 0; i < 4; ++i) kept.push_back(from_table(diagram, random_table(engine, 6, 4), 0, 0, 6));
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(engine() % kept.size()));
    diagram.collect(kept);
    const std::vector<Node> order = diagram.reachable(kept);
    ASSERT_EQ(order.size(), diagram.live());
    std::set<Node> before;
    for (const Node n : order) {
      for (const Node child : {diagram.low(n), diagram.high(n)}) {
        ASSERT_TRUE(Mtbdd::is_terminal(child) || before.contains(child));
        if (!Mtbdd::is_terminal(child) && n < child) ++turned_round;
      }
      before.insert(n);
    }
  }
  EXPECT_GT(turned_round, 0U) << "or nothing was tested";
}

// A thousand sums, of which one at a time is wanted: without collections there would be some hundred thousand nodes.
TEST(Mtbdd, CollectionsBoundALongRun) {
  std::mt19937_64 engine(8);
  Mtbdd diagram;
  const Mtbdd::Operation sum = diagram.operation();
  const auto add = [](const std::array<Node, 2>& n) -> std::optional<Node> {
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    return Mtbdd::terminal((Mtbdd::payload(n[0]) + Mtbdd::payload(n[1])) % 64);
  };
  std::vector<std::uint32_t> expected = random_table(engine, 8, 64);
  Node total = from_table(diagram, expected, 0, 0, 8);
  for (int round = 0; round < 1000; ++round) {
    const std::vector<std::uint32_t> table = random_table(engine, 8, 64);
    const Node next = from_table(diagram, table, 0, 0, 8);
    total = diagram.apply(sum, std::array{total, next}, add);
    for (std::size_t i = 0; i < table.size(); ++i) expected[i] = (expected[i] + table[i]) % 64;
    if (diagram.live() > 4096) diagram.collect(std::array{total});
    for (auto i = static_cast<std::size_t>(round % 16); i < expected.size(); i += 16)
      ASSERT_EQ(value(diagram, total, i), expected[i]) << "round " << round;
  }
  EXPECT_LE(diagram.size(), 4096U + 2 * 256U) << "one round more than the bound";
}

TEST(Mtbdd, ImportCopiesMapsLeavesAndRenames) {
  std::mt19937_64 engine(4);
  Mtbdd from, to;
  const auto table = random_table(engine, 5, 6);
  const Node f = from_table(from, table, 0, 0, 5);
  const std::vector<Node> copy = to.import(
      from, std::array{f}, [](std::uint32_t payload) { return Mtbdd::terminal(payload + 100); },
      [](Mtbdd::Variable v) { return 2 * v; });
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto bit = [&](Mtbdd::Variable v) { return v % 2 == 0 && ((i >> (v / 2)) & 1U) != 0; };
    ASSERT_EQ(Mtbdd::payload(to.evaluate(copy[0], bit)), table[i] + 100);
  }
}

TEST(Boolean, AgreesWithTruthTables) {
  std::mt19937_64 engine(5);
  Mtbdd diagram;
  Boolean logic(diagram);
  for (int round = 0; round < 100; ++round) {
    const auto a = random_table(engine, 4, 2), b = random_table(engine, 4, 2), c = random_table(engine, 4, 2);
    const Node f = from_table(diagram, a, 0, 0, 4), g = from_table(diagram, b, 0, 0, 4),
               h = from_table(diagram, c, 0, 0, 4);
    bool contained = true;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const bool x = a[i] != 0, y = b[i] != 0, z = c[i] != 0;
      ASSERT_EQ(value(diagram, logic.negate(f), i) != 0, !x);
      ASSERT_EQ(value(diagram, logic.conjunction(f, g), i) != 0, x && y);
      ASSERT_EQ(value(diagram, logic.disjunction(f, g), i) != 0, x || y);
      ASSERT_EQ(value(diagram, logic.iff(f, g), i) != 0, x == y);
      ASSERT_EQ(value(diagram, logic.if_then_else(f, g, h), i) != 0, x ? y : z);
      contained = contained && (!x || y);
    }
    ASSERT_EQ(logic.implies(f, g), contained);
  }
}

TEST(Mtbdd, ManagersOnDifferentThreadsShareNothing) {
  const auto work = [](std::size_t& nodes) {
    std::mt19937_64 engine(6);
    Mtbdd diagram;
    for (int i = 0; i < 20; ++i) from_table(diagram, random_table(engine, 10, 50), 0, 0, 10);
    nodes = diagram.size();
  };
  std::size_t first = 0, second = 0;
  std::thread one(work, std::ref(first)), two(work, std::ref(second));
  one.join();
  two.join();
  EXPECT_EQ(first, second);
  EXPECT_GT(first, 0U);
}

}  // namespace
}  // namespace waymark::automata
