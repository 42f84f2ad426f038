// Reductions keep the language: random generalised Büchi automata before and after, on all small lassos.
#include "libautomata/omega/reduce.hpp"

#include <gtest/gtest.h>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/candidate.hpp"
#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/fewest_marks.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

class Reductions : public ::testing::Test {
 protected:
  // What `change` makes of some hundred random automata accepts the same lassos, and seldom nothing or everything.
  template <class Change>
  void keep_the_language(const Change& change) {
    keep_the_language([](const TransitionRelation& a) { return a; }, change);
  }
  template <class Prepare, class Change>
  void keep_the_language(const Prepare& prepare, const Change& change) {
    constexpr std::uint64_t seed = 31;
    ltl::Random random(seed);
    const auto vocabulary = testing::letters_vocabulary(2);
    const auto words = testing::all_lassos({.length = 3, .atoms = 2});
    std::size_t accepted = 0, smaller = 0;
    constexpr std::size_t automata = testing::sanitized ? 50 : 300;
    for (std::size_t i = 0; i < automata; ++i) {
      const Automaton given = random_automaton(random, vocabulary,
                                               {.states = static_cast<std::uint32_t>(2 + random.below(5)),
                                                .sets = static_cast<std::uint32_t>(random.below(3)),
                                                .empty = 0.3,
                                                .generic = false});
      const Automaton before = as_automaton(prepare(given.transitions()), vocabulary, given.reads());
      const Automaton after = as_automaton(change(before.transitions()), vocabulary, before.reads());
      smaller += after.states() < before.states() ? 1 : 0;
      for (const ltl::Lasso& word : words) {
        accepted += accepts(before, word) ? 1 : 0;
        ASSERT_EQ(accepts(before, word), accepts(after, word))
            << "seed " << seed << ", automaton " << i << ", word " << ltl::show(word, vocabulary);
      }
    }
    EXPECT_GT(accepted, words.size() * automata / 10);
    EXPECT_LT(accepted, words.size() * automata * 9 / 10);
    RecordProperty("smaller", static_cast<int>(smaller));
  }
  Budget budget_;
};

TEST_F(Reductions, SccFilterKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) { return scc_filter(a, MarksOn::Edges, budget_); });
}
// Every branch that leaves a state carries the marks of the state.
TransitionRelation with_marks_on_states(const TransitionRelation& a) {
  TransitionRelation out;
  out.acceptance = a.acceptance;
  out.initial = a.initial;
  for (std::uint32_t q = 0; q < a.states(); ++q) {
    Marks marks;
    for (std::uint32_t set = 0; set < a.acceptance.sets; ++set)
      if ((q >> set & 1U) == 0) marks = marks | Marks::of(set);
    const auto marked = [&](std::uint32_t choice) {
      std::vector<Branch> branches;
      for (const Branch& b : a.choices[choice]) branches.push_back({b.target, marks});
      return Mtbdd::terminal(out.choices.intern(branches));
    };
    const auto keep = [](Mtbdd::Variable v) { return v; };
    out.roots.push_back(out.diagram.import(a.diagram, std::vector{a.roots[q]}, marked, keep).front());
  }
  return out;
}
TEST_F(Reductions, SccFilterKeepsTheLanguageOfMarksOnStates) {
  keep_the_language(with_marks_on_states,
                    [&](const TransitionRelation& a) { return scc_filter(a, MarksOn::States, budget_); });
}
TEST_F(Reductions, BisimulationKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) { return bisimulation_quotient(a, budget_); });
}
TEST_F(Reductions, SimulationKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) {
    const TransitionRelation merged = Simulations(a, budget_).quotient();
    return Simulations(merged, budget_).quotient();  // pruned
  });
}
TEST_F(Reductions, ReverseSimulationKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) {
    return Simulations(a, budget_).reverse_quotient(std::vector<bool>(a.states()));
  });
}
TEST_F(Reductions, DroppingWhatIsOvertakenKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) {
    const TransitionRelation merged = Simulations(a, budget_).quotient();
    return scc_filter(Simulations(merged, budget_).without_overtaken(), MarksOn::Edges, budget_);
  });
}
TEST_F(Reductions, FreeMarksKeepTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) {
    const TransitionRelation loose = with_free_marks(a).value_or(a);
    const TransitionRelation forwards = Simulations(loose, budget_).quotient();
    const TransitionRelation filtered = scc_filter(forwards, MarksOn::Edges, budget_);
    const TransitionRelation freed = with_free_marks(filtered).value_or(filtered);
    return Simulations(freed, budget_).reverse_quotient(std::vector<bool>(freed.states()));
  });
}
TEST_F(Reductions, ReduceKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) { return reduce(a, MarksOn::Edges, budget_).automaton; });
}
TEST_F(Reductions, ReduceAsMarkedKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) { return reduce_as_marked(a, budget_).automaton; });
}
TEST_F(Reductions, FewestMarksKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) { return fewest_marks(a, budget_).value_or(a); });
}
TEST_F(Reductions, DegeneralisationKeepsTheLanguage) {
  for (int rules = 0; rules < 8; ++rules)
    keep_the_language([&](const TransitionRelation& a) {
      const LevelRule rule{(rules & 1) != 0, (rules & 2) != 0, (rules & 4) != 0};
      return degeneralize(a, rule, budget_);
    });
}
TEST_F(Reductions, DegeneralisedAndReducedKeepsTheLanguage) {
  keep_the_language([&](const TransitionRelation& a) {
    const TransitionRelation general = reduce(a, MarksOn::Edges, budget_).automaton;
    return reduce(degeneralize(general, {.look_ahead = true}, budget_), MarksOn::States, budget_).automaton;
  });
}

TransitionRelation from_hoa(const char* text) { return read_omega_hoa(text).transitions(); }

// Set 0 implies set 1, whichever comes first.
TEST_F(Reductions, AnImpliedSetGoes) {
  for (const char* marks : {"[0&1] 0 {0 1} [0&!1] 0 {1} [!0] 0", "[0&1] 0 {0 1} [0&!1] 0 {0} [!0] 0"}) {
    const TransitionRelation before =
        from_hoa((std::string("HOA: v1 States: 1 Start: 0 AP: 2 \"a\" \"b\" Acceptance: 2 Inf(0)&Inf(1) --BODY-- "
                              "State: 0 ") +
                  marks + " --END--")
                     .c_str());
    EXPECT_EQ(scc_filter(before, MarksOn::Edges, budget_).acceptance.sets, 1U) << marks;
  }
}

TEST_F(Reductions, WhereAllRunsAcceptNoSetIsLeft) {
  const TransitionRelation marked = from_hoa(R"(HOA: v1 States: 1 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0)
    --BODY-- State: 0 [0] 0 {0} --END--)");
  EXPECT_EQ(scc_filter(marked, MarksOn::Edges, budget_).acceptance.sets, 0U);
}

// By states first, by edges then.
TEST_F(Reductions, ASmallerAutomatonHasFewerStatesOrAsManyAndFewerEdges) {
  const TransitionRelation two_edges = from_hoa(R"(HOA: v1 States: 1 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0)
    --BODY-- State: 0 [0] 0 {0} [!0] 0 --END--)");
  const TransitionRelation one_edge = from_hoa(R"(HOA: v1 States: 1 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0)
    --BODY-- State: 0 [0] 0 {0} --END--)");
  const TransitionRelation two_states = from_hoa(R"(HOA: v1 States: 2 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0)
    --BODY-- State: 0 [0] 1 {0} State: 1 --END--)");
  EXPECT_TRUE(smaller(one_edge, two_edges));
  EXPECT_FALSE(smaller(two_edges, one_edge));
  EXPECT_FALSE(smaller(two_edges, two_edges));
  EXPECT_TRUE(smaller(two_edges, two_states));
  EXPECT_FALSE(smaller(two_states, two_edges));
}

// Every cycle through 1 passes 0, which is marked: so is 1.
TEST_F(Reductions, AStateIsMarkedThatNoCycleReachesWithoutAMark) {
  const TransitionRelation after = scc_filter(from_hoa(R"(HOA: v1 States: 2 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0)
    --BODY-- State: 0 [0] 0 {0} [!0] 1 {0} State: 1 [t] 0 --END--)"),
                                              MarksOn::States, budget_);
  EXPECT_EQ(marked_states(after), std::vector<bool>(after.states(), true));
}

// No run needs to stay in 1: as long as it may, another one can wait in 2 and come over later.
TEST_F(Reductions, ABranchGoesWhenAnotherRunIsAheadOfItOnBothSides) {
  const TransitionRelation before =
      from_hoa(R"(HOA: v1 States: 4 Start: 0 AP: 2 "a" "b" acc-name: Buchi Acceptance: 1 Inf(0)
    --BODY-- State: 0 [0] 2 State: 1 [0&1] 1 {0} [1] 3 State: 2 [0] 2 {0} [0] 1 {0} State: 3 [t] 3 {0} --END--)");
  const TransitionRelation after = Simulations(before, budget_).without_overtaken();
  EXPECT_EQ(count_edges(before), 6U);
  EXPECT_EQ(count_edges(after), 5U);  // 1 → 1 is overtaken by 2 → 1
}

// F(G a ∨ (a ∧ X F b)): the states of G a and X F b are reached by the same beginnings.
TEST_F(Reductions, AMarkOnABranchThatLeavesItsComponentTellsNothingApart) {
  const TransitionRelation before =
      from_hoa(R"(HOA: v1 States: 5 Start: 0 AP: 2 "a" "b" acc-name: Buchi Acceptance: 1 Inf(0)
    --BODY-- State: 0 [t] 0 [0] 1 [0] 2 State: 1 [t] 3 State: 2 [0] 1 [0] 2 {0} State: 3 [!1] 3 [1] 4
    State: 4 [t] 4 {0} --END--)");
  EXPECT_EQ(reduce(before, MarksOn::Edges, budget_).automaton.states(), 4U);
}

TEST_F(Reductions, MarksThatAreAddedMayTellEqualStatesApart) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::nnf(ltl::parse("G((F c & (G !d R !a)) | (G !c & (F d U a)))", arena));
  const TransitionRelation raw = tableau(f, ltl::propositions(f), budget_).automaton;
  EXPECT_EQ(reduce(raw, MarksOn::Edges, budget_).automaton.states(), 10U);
  EXPECT_EQ(reduce_as_marked(raw, budget_).automaton.states(), 7U);
}

// With a step less than it takes the reduction is incomplete; when a stop is noticed, nothing comes back.
TEST_F(Reductions, AStopIsNoAnswer) {
  ltl::Random random(32);
  const Automaton given = random_automaton(random, testing::letters_vocabulary(2),
                                           {.states = 8, .sets = 2, .branches = 3, .empty = 0.1, .generic = false});
  std::size_t steps = 1;
  const auto is_complete = [&](std::size_t most, const std::stop_token& stop) {
    Budget budget(most, SIZE_MAX, stop);
    return reduce(given.transitions(), MarksOn::Edges, budget).complete;
  };
  while (!is_complete(steps, {})) ++steps;
  EXPECT_GT(steps, 10U);
  std::stop_source source;
  source.request_stop();
  for (std::size_t before = 0; before < steps; ++before) {  // a budget polls when it falls below 4096 steps
    try {
      is_complete(4096 + before, source.get_token());
      ADD_FAILURE() << "not stopped after " << before << " of " << steps << " steps";
    } catch (const Budget::Exceeded& spent) {
      EXPECT_EQ(spent.reason, Budget::Exceeded::Reason::Stopped);
    }
  }
}

}  // namespace
}  // namespace waymark::automata
