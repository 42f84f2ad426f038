#include "libplan/product/compose.hpp"

#include <gtest/gtest.h>

#include <boost/range/iterator_range.hpp>
#include <map>
#include <set>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/product/task_steps.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

automata::Dfa dfa_of(const std::string& formula) {
  ltl::Arena arena;
  return automata::ltlf_to_dfa(ltl::parse(formula, arena));
}

std::string show_pair(const Map& map, const ProductState& state) {
  return show(map.pose(PoseId{state.place})) + " × " + std::to_string(state.task);
}

using Edges = std::map<std::string, std::vector<std::string>>;  // pair → "ACTION pair", in order

// The reachable product by definition: a naive search that steps the automaton on whole letters.
Edges by_definition(const Map& map, const automata::Dfa& dfa, const std::vector<PoseId>& starts) {
  const auto letter = [&](const ltl::Letter& full) {
    ltl::Letter out;
    for (ltl::Proposition p : dfa.reads())
      if (full.contains(map.vocabulary().find(dfa.vocabulary().name(p)).value())) out.insert(p);
    return out;
  };
  Edges edges;
  std::vector<ProductState> todo;
  for (PoseId s : starts) todo.push_back({s.index, dfa.next(dfa.initial(), letter(map.label(s))).index});
  while (!todo.empty()) {
    const ProductState from = todo.back();
    todo.pop_back();
    const auto [it, is_new] = edges.try_emplace(show_pair(map, from));
    if (!is_new || dfa.is_trap(automata::StateId{from.task})) continue;
    for (Action action : all_actions) {
      const auto pose = map.successor(PoseId{from.place}, action);
      if (!pose) continue;
      const ProductState to{pose->index,
                            dfa.next(automata::StateId{from.task}, letter(map.letter(*pose, action))).index};
      it->second.push_back(std::string(name(action)) + " " + show_pair(map, to));
      todo.push_back(to);
    }
  }
  return edges;
}

Edges edges_of(const MapProduct& product) {
  Edges out;
  for (const ProductState& v : boost::make_iterator_range(vertices(product))) {
    auto& list = out[show_pair(product.map(), v)];
    for (auto [e, end] = out_edges(v, product); e != end; ++e)
      list.push_back(std::string(name(product.action(*e))) + " " + show_pair(product.map(), target(*e, product)));
  }
  return out;
}

TEST(Compose, IsTheReachableProductByDefinition) {
  constexpr std::uint64_t seed = 7;
  ltl::Random random(seed);
  for (const Map& map : {hallway(3), square(), plus(), shipped("l")}) {
    for (int round = 0; round < 60; ++round) {
      ltl::Arena arena(ltl::Vocabulary({"moved", "sofa", "ahead_open"}));
      const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(9), .atoms = 3});
      const automata::Dfa dfa = automata::ltlf_to_dfa(f);
      const std::vector<PoseId> starts{PoseId{static_cast<std::uint32_t>(random.below(map.poses()))},
                                       PoseId{static_cast<std::uint32_t>(random.below(map.poses()))}};
      const MapProduct product = compose(map, dfa, starts);
      EXPECT_EQ(edges_of(product), by_definition(map, dfa, starts)) << "seed " << seed << ", round " << round;
      ASSERT_EQ(product.starts().size(), 2U);
      std::size_t edges = 0;
      for (const auto& [from, list] : edges_of(product)) edges += list.size();
      EXPECT_EQ(num_edges(product), edges);
      EXPECT_EQ(product.starts()[1].place, starts[1].index);
    }
  }
}

TEST(Compose, TrapsAreNotExpanded) {
  const Map map = square();
  const automata::Dfa dfa = dfa_of("G !sofa & F blue");
  const MapProduct product = compose(map, dfa, PoseId{0});
  std::size_t traps = 0;
  for (const ProductState& v : boost::make_iterator_range(vertices(product))) {
    traps += product.is_trap(v) ? 1 : 0;
    EXPECT_EQ(out_degree(v, product) == 0, product.is_trap(v));
  }
  EXPECT_GT(traps, 0U);
}

TEST(Compose, LettersFallIntoTheClassesThatTheAutomatonTellsApart) {
  const Map map = shipped("grid");
  const automata::Dfa dfa = dfa_of("F (sofa & X moved)");
  EXPECT_EQ(TaskSteps(map, dfa).classes(), 4U);  // sofa or not × moved or not
  EXPECT_EQ(TaskSteps(map, dfa_of("F true")).classes(), 1U);
}

TEST(Compose, StopsAtItsLimits) {
  const Map map = shipped("grid");
  const automata::Dfa dfa = dfa_of("F (sofa & X F (chair & X moved))");
  const PoseId start{5};
  const MapProduct whole = compose(map, dfa, start);
  const std::size_t vertices = num_vertices(whole);
  const auto allowed = compose(map, dfa, {&start, 1}, {.states = vertices});
  ASSERT_TRUE(allowed);
  EXPECT_EQ(edges_of(*allowed), edges_of(whole));
  EXPECT_FALSE(compose(map, dfa, {&start, 1}, {.states = vertices - 1}));
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(compose(map, dfa, {&start, 1}, {.stop = source.get_token()}));
}

TEST(Compose, PropositionsThatTheMapLacksAreNamed) {
  const Map map = square();
  try {
    compose(map, dfa_of("F soffa"), PoseId{0});
    FAIL() << "accepted";
  } catch (const ltl::FormatError& error) {
    EXPECT_STREQ(error.what(), "the map square has no proposition 'soffa' (did you mean 'sofa'?)");
  }
}

}  // namespace
}  // namespace waymark::plan
