#include "libautomata/omega/transition_relation.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {
namespace {

// Two states that variables 0 and 1 lead from one to the other, marked where both hold.
TransitionRelation two_states() {
  TransitionRelation out;
  const std::uint32_t there = out.choices.intern({{1, Marks()}}),
                      both = out.choices.intern({{0, Marks::of(0)}, {1, {}}});
  const Mtbdd::Node inner = out.diagram.make(1, Mtbdd::terminal(there), Mtbdd::terminal(both));
  out.roots = {out.diagram.make(0, Mtbdd::terminal(Choices::none), inner), inner};
  out.acceptance = Acceptance::buchi();
  return out;
}

TEST(Identical, SeesEveryDifference) {
  EXPECT_TRUE(identical(two_states(), two_states()));
  const std::pair<const char*, std::function<void(TransitionRelation&)>> changes[] = {
      {"the initial state", [](TransitionRelation& a) { a.initial = 1; }},
      {"the acceptance condition", [](TransitionRelation& a) { a.acceptance = Acceptance::co_buchi(); }},
      {"a root", [](TransitionRelation& a) { a.roots[1] = a.roots[0]; }},
      {"one state more", [](TransitionRelation& a) { a.roots.push_back(a.roots[0]); }},
      {"one choice more",
       [](TransitionRelation& a) {
         a.choices.intern({{0, Marks()}});
       }},
      {"one node more", [](TransitionRelation& a) { a.diagram.make(1, Mtbdd::terminal(0), Mtbdd::terminal(1)); }},
  };
  for (const auto& [what, change] : changes) {
    TransitionRelation changed = two_states();
    change(changed);
    EXPECT_FALSE(identical(two_states(), changed)) << what;
    EXPECT_FALSE(identical(changed, two_states())) << what;
  }
}

TEST(Identical, LooksIntoChoicesAndNodes) {
  const auto one_state = [](Mtbdd::Variable variable, bool exchanged, std::uint32_t target, Marks marks) {
    TransitionRelation out;
    const Mtbdd::Node none = Mtbdd::terminal(Choices::none),
                      some = Mtbdd::terminal(out.choices.intern({{target, marks}}));
    out.roots = {out.diagram.make(variable, exchanged ? some : none, exchanged ? none : some)};
    out.acceptance = Acceptance::buchi();
    return out;
  };
  const TransitionRelation plain = one_state(0, false, 0, {});
  EXPECT_TRUE(identical(plain, one_state(0, false, 0, {})));
  EXPECT_FALSE(identical(plain, one_state(1, false, 0, {}))) << "another variable";
  EXPECT_FALSE(identical(plain, one_state(0, true, 0, {}))) << "for the other letter";
  EXPECT_FALSE(identical(plain, one_state(0, false, 1, {}))) << "to another state";
  EXPECT_FALSE(identical(plain, one_state(0, false, 0, Marks::of(0)))) << "with a mark";
}

TEST(Automaton, RefusesWhatIsNone) {
  const ltl::Vocabulary names({"a", "b"});
  const std::vector<ltl::Proposition> reads{{0}, {1}};
  EXPECT_EQ(Automaton(names, reads, two_states()).states(), 2U);
  EXPECT_THROW(Automaton(names, {{0}}, two_states()), std::invalid_argument) << "a variable that is not read";
  EXPECT_THROW(Automaton(names, {{0}, {2}}, two_states()), std::invalid_argument) << "a proposition that is unknown";
  const std::pair<const char*, std::function<void(TransitionRelation&)>> changes[] = {
      {"the initial state", [](TransitionRelation& a) { a.initial = 2; }},
      {"a target",
       [](TransitionRelation& a) {
         a.choices.intern({{2, Marks()}});
       }},
      {"a mark",
       [](TransitionRelation& a) {
         a.choices.intern({{0, Marks::of(1)}});
       }},
      {"a mark of the condition", [](TransitionRelation& a) { a.acceptance.condition = Condition::inf(1); }},
      {"a root", [](TransitionRelation& a) { a.roots[1] = Mtbdd::terminal(3); }},
      {"a terminal",
       [](TransitionRelation& a) { a.roots[1] = a.diagram.make(1, Mtbdd::terminal(1), Mtbdd::terminal(3)); }},
      {"another terminal",
       [](TransitionRelation& a) { a.roots[1] = a.diagram.make(1, Mtbdd::terminal(3), Mtbdd::terminal(1)); }},
  };
  for (const auto& [what, change] : changes) {
    TransitionRelation changed = two_states();
    change(changed);
    EXPECT_THROW(Automaton(names, reads, std::move(changed)), std::invalid_argument) << what;
  }
}

}  // namespace
}  // namespace waymark::automata
