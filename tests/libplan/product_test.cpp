// Products are graphs of Boost.Graph, and its searches run on the products that are planned on.
#include "libplan/product/product.hpp"

#include <gtest/gtest.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/pending/queue.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/product/buchi_product.hpp"
#include "libplan/product/compose.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/product/ranked_set.hpp"
#include "libplan/solve/decide.hpp"
#include "libplan/solve/product_search.hpp"
#include "tests/libplan/solve/random_models.hpp"

namespace waymark::plan {
namespace {

using Tabulated = Product<Mdp, TaskTable>;
using Lassos = Product<GridWorld, BuchiTask>;
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Tabulated>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Lassos>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<MapProduct>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<MapProduct>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<ProductMdp<GridWorld>>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<ProductMdp<GridWorld>>));

// By pair, filled as a search goes.
template <class Value>
using ByPair = std::map<ProductState, Value>;
template <class Value>
struct ByPairMap {
  using key_type = ProductState;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;
  ByPair<Value>* values;
  Value missing;
  friend Value get(const ByPairMap& map, const ProductState& s) {
    const auto at = map.values->find(s);
    return at == map.values->end() ? map.missing : at->second;
  }
  friend void put(const ByPairMap& map, const ProductState& s, Value value) { (*map.values)[s] = value; }
};
struct Costs {
  using key_type = ProductEdge;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  const Tabulated* product;
  friend double get(const Costs& costs, const ProductEdge& e) { return costs.product->cost(e); }
};
struct Indices {
  using key_type = ProductState;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;
  const ProductMdp<Mdp>* product;
  friend std::size_t get(const Indices& indices, const ProductState& s) { return indices.product->state(s).index; }
};

// One object: Dijkstra of Boost.Graph, the search of ours and value iteration agree on the least cost.
TEST(Product, BoostSearchesAndValueIterationAgreeOnOneProduct) {
  constexpr std::uint64_t seed = 21;
  ltl::Random random(seed);
  std::size_t found = 0;
  for (int i = 0; i < 200; ++i) {
    const Mdp mdp =
        testing::random_model(random, {.states = 6, .most_choices = 3, .deterministic = true, .unit_costs = false});
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2});
    const TaskTable task(automata::ltlf_to_dfa(f), mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    ASSERT_TRUE(product);
    if (product->starts().empty()) continue;
    const ProductState start = product->state(product->starts()[0]);
    ByPair<double> cost{{start, 0.0}};
    ByPair<boost::default_color_type> color;
    ByPair<ProductState> before;
    boost::dijkstra_shortest_paths_no_init(*product, start, ByPairMap<ProductState>{&before, {}},
                                           ByPairMap<double>{&cost, INFINITY}, Costs{&*product}, Indices{&*product},
                                           std::less<>(), std::plus<>(), 0.0, boost::default_dijkstra_visitor(),
                                           ByPairMap<boost::default_color_type>{&color, boost::white_color});
    EXPECT_EQ(color.size(), num_vertices(*product)) << "all that is numbered is met";
    double least = INFINITY;
    for (auto [v, end] = vertices(*product); v != end; ++v)
      if (product->is_goal(*v)) least = std::min(least, cost.at(*v));
    const auto searched = search(*product);
    ASSERT_TRUE(searched);
    ASSERT_EQ(searched->route.has_value(), std::isfinite(least)) << ltl::print(f) << ", model " << i;
    if (!searched->route) continue;
    ++found;
    EXPECT_EQ(searched->route->cost, least) << ltl::print(f) << ", model " << i;
    const auto iterated = least_cost(*product);
    ASSERT_TRUE(iterated);
    EXPECT_NEAR(iterated->value.middle(), least, 1e-6) << ltl::print(f) << ", model " << i;
  }
  EXPECT_GT(found, 40U);
}

TEST(Product, BreadthFirstMeetsEveryPairThatIsNumbered) {
  ltl::Random random(22);
  for (int i = 0; i < 100; ++i) {
    const Mdp mdp = testing::random_model(random, {.states = 5});
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2});
    const TaskTable task(automata::ltlf_to_dfa(f), mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    ASSERT_TRUE(product);
    std::size_t edges = 0;
    for (auto [v, end] = vertices(*product); v != end; ++v) edges += out_degree(*v, *product);
    EXPECT_EQ(edges, product->edges());
    if (product->starts().empty()) continue;
    const Tabulated implicit(mdp, task);
    ByPair<boost::default_color_type> color;
    boost::queue<ProductState> open;
    boost::breadth_first_visit(implicit, product->state(product->starts()[0]), open, boost::default_bfs_visitor(),
                               ByPairMap<boost::default_color_type>{&color, boost::white_color});
    EXPECT_EQ(color.size(), num_vertices(*product));
  }
}

// The edges of a pair, one after the other, are its successors by every choice; a jump stays in its place and is free.
TEST(Product, JumpsOfTheAutomatonAreEdges) {
  constexpr std::uint64_t seed = 23;
  ltl::Random random(seed);
  std::size_t jumps = 0;
  for (int i = 0; i < 60; ++i) {
    const char* const formulas[] = {"F G a", "F G a | G F b", "F (a & G F b)", "X F G (a | X b)"};
    const char* const f = formulas[i % 4];
    const Mdp mdp = testing::random_model(random, {.states = 4, .unit_costs = false});
    ltl::Arena arena(testing::vocabulary_ab());
    const TaskTable task(automata::ltl_to_ldba(ltl::parse(f, arena)), mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    ASSERT_TRUE(product);
    for (auto [v, last] = vertices(*product); v != last; ++v) {
      std::vector<std::pair<std::uint32_t, ProductState>> expected, found;
      for (std::uint32_t k = 0; k < product->choices(*v); ++k)
        product->for_each_successor(*v, k, [&](const ProductState& to) { expected.emplace_back(k, to); });
      for (auto [e, end] = out_edges(*v, *product); e != end; ++e) {
        found.emplace_back(e->choice, target(*e, *product));
        EXPECT_EQ(source(*e, *product), *v);
        if (!product->is_jump(*v, e->choice)) continue;
        ++jumps;
        EXPECT_EQ(e->to.place, v->place);
        EXPECT_EQ(product->cost(*e), 0);
      }
      EXPECT_EQ(found, expected) << f << ", model " << i << ", seed " << seed;
    }
  }
  EXPECT_GT(jumps, 50U);
}

TEST(RankedSet, CountsWhatComesBefore) {
  constexpr std::uint64_t size = 60'000;  // several strides of select
  ltl::Random random(25);
  RankedSet set(size);
  std::set<std::uint64_t> expected;
  for (int i = 0; i < 4'000; ++i) {
    const std::uint64_t member = random.below(size);
    EXPECT_EQ(set.insert(member), expected.insert(member).second);
  }
  set.rank();
  for (std::uint64_t i = 0; i < size; i += 1 + random.below(100)) {
    EXPECT_EQ(set.contains(i), expected.contains(i)) << i;
    const auto at = expected.lower_bound(i);
    const auto before = static_cast<std::uint32_t>(std::distance(expected.begin(), at));
    EXPECT_EQ(set.rank(i), before) << i;
    if (at == expected.end()) continue;
    EXPECT_EQ(set.select(before), *at) << i;
    std::vector<std::uint64_t> some;
    set.for_each(i, [&](std::uint64_t member) {
      some.push_back(member);
      return some.size() < 3;
    });
    const auto last = std::next(at, std::min<std::ptrdiff_t>(3, std::distance(at, expected.end())));
    EXPECT_EQ(some, std::vector<std::uint64_t>(at, last)) << i;
  }
}

TEST(Product, IsExploredWithinItsLimits) {
  ltl::Random random(24);
  const Mdp mdp = testing::random_model(random, {.states = 5});
  ltl::Arena arena(testing::vocabulary_ab());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F (a & F b)", arena)), mdp.letters());
  const std::size_t states = ProductMdp<Mdp>::explore(mdp, task)->states();
  ASSERT_GT(states, 5U);
  EXPECT_TRUE(ProductMdp<Mdp>::explore(mdp, task, {.states = states}));
  EXPECT_FALSE(ProductMdp<Mdp>::explore(mdp, task, {.states = states - 1}));
  const TaskTable done(automata::ltlf_to_dfa(arena.constant(true)), mdp.letters());
  EXPECT_EQ(ProductMdp<Mdp>::explore(mdp, done)->states(), 1U);
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(ProductMdp<Mdp>::explore(mdp, done, {.stop = source.get_token()})) << "looked at before the first state";
}

TEST(AlphabetClasses, UnknownPropositionsAreWhatTheCallerSays) {
  Letters letters(ltl::Vocabulary({"a", "b"}));
  const LetterId none = letters.intern({}), a = letters.intern({ltl::Proposition{0}}),
                 b = letters.intern({ltl::Proposition{1}});
  const ltl::Vocabulary reads({"c", "b"});
  const std::vector<ltl::Proposition> all{{0}, {1}};
  const AlphabetClasses classes(letters, reads, all, UnknownProposition::NeverHolds);
  EXPECT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes.of(none), classes.of(a));
  EXPECT_EQ(classes.representatives()[classes.of(b)], ltl::Letter{ltl::Proposition{1}});
  try {
    const AlphabetClasses refused(letters, reads, all, UnknownProposition::Refuse, "the map");
    FAIL() << "accepted";
  } catch (const ltl::FormatError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 29), "the map has no proposition 'c");
  }
}

}  // namespace
}  // namespace waymark::plan
