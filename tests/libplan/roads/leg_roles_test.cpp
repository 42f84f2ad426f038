// Letters that do no harm: against all words up to a length, and against a search for a word that tells them apart.
#include "libplan/roads/leg_roles.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/roads/contract.hpp"
#include "libplan/roads/road_search.hpp"
#include "tests/libplan/roads/random_roads.hpp"

namespace waymark::plan {
namespace {

using testing::random_roads;

// The definition, on one word: is a goal met?
bool meets_goal(const TaskTable& task, std::uint32_t state, const std::vector<LetterId>& word) {
  for (const LetterId letter : word) {
    if (state == TaskTable::trap || task.is_goal(state)) break;
    state = task.next(state, letter).target;
  }
  return state != TaskTable::trap && task.is_goal(state);
}

// A word that leads from p to a goal, and from q to none on the way: by depth first search over pairs.
bool is_told_apart(const TaskTable& task, std::size_t letters, std::uint32_t p, std::uint32_t q) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{p, q}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (a == TaskTable::trap || (b != TaskTable::trap && task.is_goal(b)) || !seen.emplace(a, b).second) continue;
    if (task.is_goal(a)) return true;
    for (std::uint32_t l = 0; l < letters; ++l)
      open.emplace_back(task.next(a, LetterId{l}).target,
                        b == TaskTable::trap ? TaskTable::trap : task.next(b, LetterId{l}).target);
  }
  return false;
}

// All words of up to so many letters that meet a goal from p, where q meets none.
bool some_word_tells_apart(const TaskTable& task, std::uint32_t letters, std::uint32_t p, std::uint32_t q,
                           std::vector<LetterId>& word, std::size_t most) {
  if (meets_goal(task, p, word) && !meets_goal(task, q, word)) return true;
  if (word.size() == most) return false;
  for (std::uint32_t l = 0; l < letters; ++l) {
    word.push_back(LetterId{l});
    const bool told = some_word_tells_apart(task, letters, p, q, word, most);
    word.pop_back();
    if (told) return true;
  }
  return false;
}

TEST(LegRoles, DoNoHarmByTheDefinition) {
  ltl::Random random(5);
  std::size_t harmless = 0, harmful = 0;
  for (int i = 0; i < 2000; ++i) {
    const RoadGraph graph = random_roads(random, {.nodes = 8, .arcs = 12});
    const auto letters = static_cast<std::uint32_t>(graph.letters().size());
    ltl::Arena arena(graph.letters().vocabulary());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 1 + random.below(9), .atoms = 3});
    const TaskTable task(automata::ltlf_to_dfa(f), graph.letters());
    const LegRoles roles(graph, *contract(graph), task);
    bool has_dead_end = false;  // no goal can be reached by letters of the map; then less is known
    for (std::uint32_t q = 0; q < task.states(); ++q) has_dead_end |= !is_told_apart(task, letters, q, TaskTable::trap);
    for (std::uint32_t q = 0; q < task.states(); ++q)
      for (std::uint32_t l = 0; l < letters && !task.is_goal(q); ++l) {
        const std::uint32_t next = task.next(q, LetterId{l}).target;
        if (!roles.is_in_core(LetterId{l}) || next == q || next == TaskTable::trap) {
          ASSERT_FALSE(roles.is_harmless(q, LetterId{l}));
          continue;
        }
        const bool known = roles.is_harmless(q, LetterId{l});
        ++(known ? harmless : harmful);
        const bool told = is_told_apart(task, letters, q, next);
        std::vector<LetterId> word;
        if (!known) {
          ASSERT_TRUE(told || has_dead_end) << ltl::print(f) << " state " << q << " letter " << l;
        } else {
          ASSERT_FALSE(told) << ltl::print(f) << " state " << q << " letter " << l;
          ASSERT_FALSE(some_word_tells_apart(task, letters, q, next, word, 4)) << ltl::print(f) << " state " << q;
        }
        ASSERT_EQ(roles.of(q)[l], known ? LegRole::Either : LegRole::Leads);
      }
  }
  EXPECT_GT(harmless, 100U);
  EXPECT_GT(harmful, 100U);
}

TEST(LegRoles, AreNotKnownPastTheLimitOrOutsideTheCore) {
  ltl::Random random(6);
  const RoadGraph graph = random_roads(random, {.nodes = 12, .arcs = 24});
  ltl::Arena arena(graph.letters().vocabulary());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a & F b", arena)), graph.letters());
  ContractionOptions bits;
  bits.rare = 0;
  const auto all = contract(graph), none = contract(graph, bits);
  std::size_t known = 0, limited = 0, outside = 0;
  for (std::uint32_t q = 0; q < task.states(); ++q)
    for (std::uint32_t l = 0; l < graph.letters().size(); ++l) {
      known += LegRoles(graph, *all, task).is_harmless(q, LetterId{l}) ? 1 : 0;
      limited += LegRoles(graph, *all, task, 0).is_harmless(q, LetterId{l}) ? 1 : 0;
      outside += LegRoles(graph, *none, task).is_harmless(q, LetterId{l}) ? 1 : 0;
    }
  EXPECT_GT(known, 0U);
  EXPECT_EQ(limited, 0U);
  EXPECT_EQ(outside, 0U);
}

// A line of streets with one node for each of a, b and x: a search from each, instead of one for each state.
TEST(SharedLegs, SearchOnceFromEachNode) {
  RoadGraph::Parts parts;
  parts.letters = Letters(ltl::Vocabulary(std::vector<std::string>{"a", "b", "c", "d", "e"}));
  parts.letters.intern({});
  constexpr std::uint32_t nodes = 60;
  for (std::uint32_t v = 0; v < nodes; ++v) {
    ltl::Letter letter;
    if (v % 10 == 5 && v > 10) letter.insert(ltl::Proposition{v / 10 - 1});
    parts.letter.push_back(static_cast<std::uint16_t>(parts.letters.intern(letter).index));
    for (const std::uint32_t w : {v + 1, v + nodes - 1}) {
      parts.tails.push_back(v);
      parts.arcs.push_back({w % nodes, 1 + v % 3});
    }
  }
  const RoadGraph graph(std::move(parts));
  ltl::Arena arena(graph.letters().vocabulary());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a & F b & F c & F d & F e", arena)), graph.letters());
  const auto hierarchy = contract(graph);
  const auto own = least_route(graph, *hierarchy, task, {.shared = SharedLegs::Use::Never});
  const auto shared = least_route(graph, *hierarchy, task);
  ASSERT_TRUE(own->route && shared->route);
  EXPECT_EQ(own->route->cost, shared->route->cost);
  EXPECT_EQ(task.states(), 32U);  // what is left: a set of five
  EXPECT_LT(3 * shared->statistics.met, own->statistics.met);
}

}  // namespace
}  // namespace waymark::plan
