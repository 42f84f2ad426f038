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

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/print.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/product/buchi_product.hpp"
#include "libplan/product/compose.hpp"
#include "libplan/product/product_mdp.hpp"
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
