// BuDDy, the decision diagram package of Debian, as an oracle: the same functions under the same order of variables
// have the same diagrams there, node for node. It has one manager a process, so one fixture owns it.
#include <bdd.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/finite/guard.hpp"
#include "libltl/structure/random.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Buddy : public ::testing::Test {
 protected:
  static constexpr int variables = 10;

  static void SetUpTestSuite() {
    bdd_init(100'000, 10'000);
    bdd_setvarnum(variables);
    bdd_gbc_hook(nullptr);  // it reports collections on standard error otherwise
  }
  static void TearDownTestSuite() { bdd_done(); }

  struct Both {
    Node ours;
    bdd theirs;
  };

  Both constant(bool value) { return {Boolean::constant(value), value ? bdd_true() : bdd_false()}; }
  Both variable(std::size_t v) {
    return {logic_.variable(static_cast<Mtbdd::Variable>(v)), bdd_ithvar(static_cast<int>(v))};
  }
  // The same operation on both sides; named, so that a failure can be told.
  Both apply(std::size_t operation, const Both& f, const Both& g, const Both& h) {
    switch (operation) {
      case 0: return {logic_.conjunction(f.ours, g.ours), f.theirs & g.theirs};
      case 1: return {logic_.disjunction(f.ours, g.ours), f.theirs | g.theirs};
      case 2: return {logic_.negate(f.ours), !f.theirs};
      case 3: return {logic_.iff(f.ours, g.ours), bdd_biimp(f.theirs, g.theirs)};
      default: return {logic_.if_then_else(f.ours, g.ours, h.ours), bdd_ite(f.theirs, g.theirs, h.theirs)};
    }
  }

  // Node for node, by a walk over both at once.
  ::testing::AssertionResult isomorphic(Node ours, const bdd& theirs) {
    std::map<int, Node> image;
    if (!walk(ours, theirs, image)) return ::testing::AssertionFailure() << "different functions";
    const std::size_t nodes = diagram_.reachable(std::array{ours}).size();
    if (nodes != static_cast<std::size_t>(bdd_nodecount(theirs)))
      return ::testing::AssertionFailure() << nodes << " nodes, BuDDy has " << bdd_nodecount(theirs);
    return ::testing::AssertionSuccess();
  }

  // By the cubes of our guard, none of which can be left out.
  ::testing::AssertionResult is_covered(const Both& f) {
    std::vector<bdd> cubes;
    for (const Cube& cube : irredundant_cover(diagram_, logic_, f.ours)) {
      bdd product = bdd_true();
      for (const Literal& literal : cube) {
        const int v = static_cast<int>(literal.variable);
        product = product & (literal.positive ? bdd_ithvar(v) : bdd_nithvar(v));
      }
      cubes.push_back(product);
    }
    for (std::size_t skipped = 0; skipped <= cubes.size(); ++skipped) {  // none at the end
      bdd sum = bdd_false();
      for (std::size_t j = 0; j < cubes.size(); ++j)
        if (j != skipped) sum = sum | cubes[j];
      if ((sum == f.theirs) != (skipped == cubes.size()))
        return ::testing::AssertionFailure() << "cube " << skipped << " of " << cubes.size();
    }
    return ::testing::AssertionSuccess();
  }

  Mtbdd diagram_;
  Boolean logic_{diagram_};

 private:
  bool walk(Node ours, const bdd& theirs, std::map<int, Node>& image) {
    if (theirs == bdd_true() || theirs == bdd_false())
      return ours == Boolean::constant(theirs == bdd_true() ? true : false);
    const auto [known, fresh] = image.try_emplace(theirs.id(), ours);
    if (!fresh) return known->second == ours;
    return !Mtbdd::is_terminal(ours) && static_cast<int>(diagram_.variable(ours)) == bdd_var(theirs) &&
           walk(diagram_.low(ours), bdd_low(theirs), image) && walk(diagram_.high(ours), bdd_high(theirs), image);
  }
};

// A pool of functions that grows by random operations on random members.
TEST_F(Buddy, RandomOperationsGiveTheSameDiagrams) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ltl::Random random(seed);
    std::vector<Both> pool{constant(false), constant(true)};
    for (std::size_t v = 0; v < variables; ++v) pool.push_back(variable(v));
    for (int step = 0; step < 400; ++step) {
      const std::size_t operation = random.below(5);
      const Both f = pool[random.below(pool.size())], g = pool[random.below(pool.size())],
                 h = pool[random.below(pool.size())];
      pool.push_back(apply(operation, f, g, h));
      ASSERT_TRUE(isomorphic(pool.back().ours, pool.back().theirs))
          << "seed " << seed << ", step " << step << ", operation " << operation;
      ASSERT_EQ(logic_.implies(f.ours, g.ours), bdd_imp(f.theirs, g.theirs) == bdd_true())
          << "seed " << seed << ", step " << step;
    }
    for (std::size_t i = 0; i < pool.size(); ++i)  // canonical: equal here as they are equal there
      for (std::size_t j = 0; j < i; j += 7)
        ASSERT_EQ(pool[i].ours == pool[j].ours, pool[i].theirs == pool[j].theirs) << "seed " << seed;
  }
}

// The pool forgets members and gives their nodes up; operations on those that stay are those of BuDDy, whose own
// collections follow its reference counts. Results from before a collection are asked for again after it.
TEST_F(Buddy, CollectionsBetweenOperationsChangeNoFunction) {
  std::size_t swept = 0, most = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ltl::Random random(seed);
    std::vector<Both> pool;
    for (std::size_t v = 0; v < variables; ++v) pool.push_back(variable(v));
    for (int step = 0; step < 600; ++step) {
      const std::size_t operation = random.below(5);
      const Both f = pool[random.below(pool.size())], g = pool[random.below(pool.size())],
                 h = pool[random.below(pool.size())];
      pool.push_back(apply(operation, f, g, h));
      ASSERT_EQ(logic_.implies(f.ours, g.ours), bdd_imp(f.theirs, g.theirs) == bdd_true())
          << "seed " << seed << ", step " << step;
      if (pool.size() > 40) pool.erase(pool.begin() + static_cast<std::ptrdiff_t>(random.below(pool.size())));
      if (step % 20 == 19) {
        std::vector<Node> roots;
        for (const Both& member : pool) roots.push_back(member.ours);
        most = std::max(most, diagram_.live());
        diagram_.collect(roots);
        ASSERT_EQ(diagram_.live(), diagram_.reachable(roots).size());
        swept += diagram_.size() - diagram_.live();
      }
      for (auto i = static_cast<std::size_t>(step % 5); i < pool.size(); i += 5)
        ASSERT_TRUE(isomorphic(pool[i].ours, pool[i].theirs)) << "seed " << seed << ", step " << step;
    }
    for (std::size_t i = 0; i < pool.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_EQ(pool[i].ours == pool[j].ours, pool[i].theirs == pool[j].theirs) << "seed " << seed;
  }
  EXPECT_GT(swept, 0U) << "or nothing was tested";
  EXPECT_EQ(diagram_.size(), most) << "there are no more slots than nodes were alive at once";
}

// With more than two terminals: each payload's characteristic function, and a copy in which nodes are appended.
TEST_F(Buddy, TerminalsPartitionTheAssignments) {
  constexpr std::uint32_t payloads = 5;
  ltl::Random random(40);
  for (int i = 0; i < 40; ++i) {
    Node all = Mtbdd::terminal(0);
    std::vector<bdd> of(payloads, bdd_false());
    of[0] = bdd_true();
    for (std::uint32_t k = 1; k < payloads; ++k) {  // payload k on a random cube, on top of what is there
      Both cube = constant(true);
      for (std::size_t v = 0; v < variables; ++v)
        if (random.chance(0.3)) {
          const Both positive = variable(v), literal = apply(random.chance(0.5) ? 0 : 2, positive, positive, cube);
          cube = apply(0, cube, literal, cube);
        }
      all = logic_.if_then_else(cube.ours, Mtbdd::terminal(k), all);
      for (std::uint32_t j = 0; j < payloads; ++j) of[j] = j == k ? of[j] | cube.theirs : of[j] & !cube.theirs;
    }
    Mtbdd copy;
    const Node copied = copy.import(
        diagram_, std::array{all}, [](std::uint32_t k) { return Mtbdd::terminal(k + 7); },
        [](Mtbdd::Variable v) { return v + 1; }, Mtbdd::Images::StayApart)[0];
    ASSERT_EQ(copy.size(), diagram_.reachable(std::array{all}).size());
    for (std::uint32_t k = 0; k < payloads; ++k) {
      const std::vector<Node> is_k = diagram_.import(
          copy, std::array{copied}, [&](std::uint32_t j) { return Boolean::constant(j == k + 7); },
          [](Mtbdd::Variable v) { return v - 1; });
      ASSERT_TRUE(isomorphic(is_k[0], of[k])) << "function " << i << ", payload " << k;
    }
  }
}

TEST_F(Buddy, CoversOfGuardsAreExactAndNoCubeIsIdle) {
  ltl::Random random(41);
  for (int i = 0; i < 60; ++i) {
    std::vector<Both> pool;
    for (std::size_t v = 0; v < 6; ++v) pool.push_back(variable(v));
    for (int step = 0; step < 30; ++step) {
      const std::size_t operation = random.below(5);
      const Both f = pool[random.below(pool.size())], g = pool[random.below(pool.size())],
                 h = pool[random.below(pool.size())];
      pool.push_back(apply(operation, f, g, h));
    }
    for (const Both& f : pool) ASSERT_TRUE(is_covered(f)) << "round " << i;
  }
}

}  // namespace
}  // namespace waymark::automata
