#include "libautomata/finite/dfa.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "libautomata/finite/guard.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/run.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::automata {
namespace {

using ltl::Letter;
using ltl::Proposition;
using ltl::Trace;

constexpr Proposition a{0}, b{1}, c{2};

Dfa translate(std::string_view text) {
  ltl::Arena arena(ltl::Vocabulary({"a", "b", "c"}));
  return ltlf_to_dfa(ltl::parse(text, arena));
}

TEST(Dfa, RefusesWhatIsNoAutomaton) {
  const ltl::Vocabulary names({"a"});
  const auto make = [&](std::uint32_t terminal, std::vector<bool> accepting, std::uint32_t initial) {
    Mtbdd diagram;
    const Mtbdd::Node root = diagram.make(0, Mtbdd::terminal(0), Mtbdd::terminal(terminal));
    return Dfa(names, {a}, diagram, {root, Mtbdd::terminal(0)}, std::move(accepting), StateId{initial});
  };
  EXPECT_EQ(make(1, {false, true}, 0).states(), 2U);
  EXPECT_THROW(make(2, {false, true}, 0), std::invalid_argument) << "an edge to no state";
  EXPECT_THROW(make(1, {false}, 0), std::invalid_argument) << "an acceptance bit is missing";
  EXPECT_THROW(make(1, {false, true}, 1), std::invalid_argument) << "the empty word would be accepted";
  EXPECT_THROW(make(1, {false, true}, 2), std::invalid_argument) << "no such initial state";
  Mtbdd two_roots;
  const Mtbdd::Node good = two_roots.make(0, Mtbdd::terminal(0), Mtbdd::terminal(1)),
                    bad = two_roots.make(0, Mtbdd::terminal(1), Mtbdd::terminal(2));
  EXPECT_THROW(Dfa(names, {a}, two_roots, {good, bad}, {false, true}, StateId{0}), std::invalid_argument)
      << "an edge to no state from the other state";
  Mtbdd diagram;
  const Mtbdd::Node root = diagram.make(1, Mtbdd::terminal(0), Mtbdd::terminal(1));
  EXPECT_THROW(Dfa(names, {a}, diagram, {root, root}, {false, true}, StateId{0}), std::invalid_argument)
      << "a variable that is not read";
  EXPECT_THROW(Dfa(names, {b}, Mtbdd(), {Mtbdd::terminal(0)}, {false}, StateId{0}), std::invalid_argument)
      << "a proposition outside the vocabulary";
}

TEST(Dfa, SaysThatThereIsNoSuchInitialState) {
  Mtbdd diagram;
  const Mtbdd::Node root = diagram.make(0, Mtbdd::terminal(0), Mtbdd::terminal(1));
  try {
    const Dfa dfa(ltl::Vocabulary({"a"}), {a}, diagram, {root, Mtbdd::terminal(0)}, {false, true}, StateId{2});
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "the initial state of a DFA must be one of its states");
  }
}

TEST(Dfa, ReadsOnlyWhatMatters) {
  EXPECT_EQ(translate("F b").reads(), std::vector<Proposition>{b});
  EXPECT_EQ(translate("(a | !a) & F c").reads(), std::vector<Proposition>{c});
  EXPECT_EQ(translate("F a | G !a").reads(), std::vector<Proposition>{}) << "true after all";
  EXPECT_EQ(translate("a U (b & X c)").reads(), (std::vector<Proposition>{a, b, c}));
  EXPECT_EQ(translate("F b").vocabulary().names(), (std::vector<std::string>{"a", "b", "c"}));
}

TEST(Dfa, KnowsTrapsAndDistances) {
  const Dfa dfa = translate("X (a & X b)");  // q0 → q1 -a→ q2 -b→ accepting
  EXPECT_EQ(dfa.distance_to_acceptance(dfa.initial()), 3U);
  EXPECT_FALSE(dfa.is_trap(dfa.initial()));
  const StateId second = dfa.next(dfa.initial(), {});
  EXPECT_EQ(dfa.distance_to_acceptance(second), 2U);
  const StateId lost = dfa.next(second, {b});
  EXPECT_TRUE(dfa.is_trap(lost));
  EXPECT_EQ(dfa.distance_to_acceptance(lost), Dfa::unreachable);
  const StateId done = dfa.next(dfa.next(second, {a}), {b});
  EXPECT_TRUE(dfa.is_accepting(done));
  EXPECT_EQ(dfa.distance_to_acceptance(done), 0U);
}

TEST(Dfa, MeasuresTheDistanceFromEveryState) {
  Mtbdd diagram;  // q1 is initial; q0 accepts and is never left; a leads from q1 to q0, and no letter out of q2
  const Mtbdd::Node root = diagram.make(0, Mtbdd::terminal(2), Mtbdd::terminal(0));
  const Dfa dfa(ltl::Vocabulary({"a"}), {a}, diagram, {Mtbdd::terminal(0), root, Mtbdd::terminal(2)},
                {true, false, false}, StateId{1});
  EXPECT_EQ(dfa.distance_to_acceptance(StateId{0}), 0U);
  EXPECT_EQ(dfa.distance_to_acceptance(StateId{1}), 1U);
  EXPECT_EQ(dfa.distance_to_acceptance(StateId{2}), Dfa::unreachable);
}

TEST(Run, VisitsStatesAndNoticesTheTrapEarly) {
  const Dfa dfa = translate("!b U a");
  const automata::Run good = run(dfa, Trace({Letter{}, Letter{a}, Letter{b}}));
  EXPECT_TRUE(good.accepted);
  EXPECT_EQ(good.states.size(), 4U);
  EXPECT_EQ(good.states.front(), dfa.initial());
  EXPECT_FALSE(good.trapped.has_value());
  const automata::Run bad = run(dfa, Trace({Letter{}, Letter{b}, Letter{a}, Letter{a}}));
  EXPECT_FALSE(bad.accepted);
  EXPECT_EQ(bad.trapped, 2U) << "after {b} there is no hope";
  const automata::Run hopeless = run(translate("false"), Trace({Letter{a}}));
  EXPECT_EQ(hopeless.trapped, 0U) << "the empty language is lost from the start";
}

TEST(Run, ShortestWordIsShortestAndAccepted) {
  const struct {
    const char* formula;
    std::size_t length;
  } table[] = {
      {"true", 1},          {"a", 1},          {"X a", 2},     {"X X X true", 4},
      {"F (a & X F b)", 2}, {"F a & F !a", 2}, {"N false", 1}, {"G (a -> X b) & F a & G !b | X X (a & !b)", 3},
  };
  for (const auto& row : table) {
    const Dfa dfa = translate(row.formula);
    const std::optional<Trace> word = shortest_word(dfa);
    ASSERT_TRUE(word.has_value()) << row.formula;
    EXPECT_TRUE(accepts(dfa, *word)) << row.formula;
    EXPECT_EQ(word->size(), row.length) << row.formula;
  }
  for (const char* unsatisfiable : {"false", "a & X !a & G a", "X (N false & X true)"})
    EXPECT_FALSE(shortest_word(translate(unsatisfiable)).has_value()) << unsatisfiable;
}

// Without `a` or without `b`, the same node about `c` leads no nearer: it is met twice.
TEST(Run, ShortestWordIsNotLedAstrayByANodeThatIsMetTwice) {
  const Dfa dfa = translate("a & b & X true | !(a & b) & (c & X X a | !c & X X b)");
  const std::optional<Trace> word = shortest_word(dfa);
  ASSERT_TRUE(word.has_value());
  EXPECT_EQ(word->size(), 2U);
  EXPECT_TRUE(accepts(dfa, *word));
}

// Without `a`, `c` decides between two states that are equally far from acceptance.
TEST(Run, ShortestWordPassesBranchesThatLeadNoNearer) {
  Mtbdd diagram;
  const Mtbdd::Node aside = diagram.make(1, Mtbdd::terminal(0), Mtbdd::terminal(1)),
                    far = diagram.make(0, aside, Mtbdd::terminal(2)),
                    near = diagram.make(0, Mtbdd::terminal(2), Mtbdd::terminal(3));
  const Dfa dfa(ltl::Vocabulary({"a", "c"}), {a, b}, diagram, {far, far, near, Mtbdd::terminal(3)},
                {false, false, false, true}, StateId{0});
  const std::optional<Trace> word = shortest_word(dfa);
  ASSERT_TRUE(word.has_value());
  EXPECT_EQ(word->size(), 2U);
  EXPECT_TRUE(accepts(dfa, *word));
  for (const Letter& letter : *word) EXPECT_EQ(letter, Letter{a});
}

TEST(Dfa, CountsStatesEdgesAndNodes) {
  const Dfa dfa = translate("F a & F b");
  EXPECT_EQ(dfa.states(), 4U);
  EXPECT_EQ(count_edges(dfa), 9U) << "4 + 2 + 2 + 1 pairs of states";
  EXPECT_EQ(count_nodes(dfa), 4U) << "three below the first root, and the one that asks for a alone";
}

}  // namespace
}  // namespace waymark::automata
