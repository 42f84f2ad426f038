// HOA texts in every construct that ω-automata may use, and what they mean; what is written is read back.
#include "libautomata/hoa/omega.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libautomata/omega/random_automaton.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

const ltl::Vocabulary ab({"a", "b"});

// On all small lassos over a and b.
::testing::AssertionResult means(const std::string& hoa, std::string_view formula) {
  const std::string text = "HOA: v1 AP: 2 \"a\" \"b\" " + hoa + " --END--";
  const Automaton automaton = read_omega_hoa(text);
  ltl::Arena arena{ab};
  const ltl::Formula f = ltl::parse(formula, arena);
  ::testing::AssertionResult result = ::testing::AssertionSuccess();
  testing::for_each_lasso({.length = 4, .atoms = 2}, [&](const ltl::Lasso& word) {
    if (result && referee::accepts(automaton, word) != ltl::holds(word, f))
      result = ::testing::AssertionFailure() << "differs from " << formula << " on " << ltl::show(word, ab);
  });
  return result;
}

TEST(OmegaHoa, ReadsNondeterminismAndSeveralInitialStates) {
  EXPECT_TRUE(means("Start: 0 Acceptance: 1 Inf(0) --BODY-- State: 0 [t] 0 [0] 1 State: 1 {0} [0] 1", "F G a"));
  EXPECT_TRUE(means("Start: 0 Start: 1 Acceptance: 0 t --BODY-- State: 0 [0] 0 State: 1 [1] 1", "G a | G b"));
  EXPECT_TRUE(means("Acceptance: 0 t --BODY-- State: 0 [0] 0", "false"));
}

TEST(OmegaHoa, ReadsEveryCondition) {
  const std::string body = " --BODY-- State: 0 [0&!1] 0 {0} [!0&1] 0 {1} [0&1] 0 {0 1} [!0&!1] 0";
  EXPECT_TRUE(means("Start: 0 Acceptance: 2 Inf(0)" + body, "G F a"));
  EXPECT_TRUE(means("Start: 0 Acceptance: 2 Fin(0)" + body, "F G !a"));
  EXPECT_TRUE(means("Start: 0 Acceptance: 2 Inf(!0)" + body, "G F !a"));
  EXPECT_TRUE(means("Start: 0 Acceptance: 2 Fin(!0)|Inf(1)" + body, "F G a | G F b"));
  EXPECT_TRUE(means("Start: 0 Acceptance: 2 Inf(0)&Inf(1)" + body, "G F a & G F b"));
  EXPECT_TRUE(
      means("Start: 0 Acceptance: 2 Fin(0)&Inf(1) | Fin(1)&Inf(0)" + body, "(F G !a & G F b) | (F G !b & G F a)"));
  EXPECT_TRUE(means("Start: 0 Acceptance: 0 f --BODY-- State: 0 [t] 0", "false"));
}

TEST(OmegaHoa, ReadsMarksOnStatesLabelsOnStatesAndAliases) {
  EXPECT_TRUE(means("Start: 0 Acceptance: 1 Inf(0) --BODY-- State: 0 [0] 1 [!0] 0 State: 1 {0} [0] 1 [!0] 0", "G F a"));
  EXPECT_TRUE(means("Start: 0 Start: 1 Acceptance: 1 Inf(0) --BODY-- State: [0] 0 {0} 0 1 State: [!0] 1 0 1", "G F a"));
  EXPECT_TRUE(means("Start: 0 Alias: @x 0&1 Alias: @y !@x Acceptance: 0 t --BODY-- State: 0 [@y] 0", "G !(a & b)"));
  EXPECT_TRUE(means("Start: 0 Acceptance: 1 Inf(0) --BODY-- State: 0 0 0 {0} 0 0 {0}", "G F a"));
}

TEST(OmegaHoa, RemovesUniversalBranches) {
  EXPECT_TRUE(means("Start: 0&1 Acceptance: 1 Inf(0) --BODY-- State: 0 [0] 0 {0} [!0] 0 State: 1 [1] 1 {0} [!1] 1",
                    "G F a & G F b"));
  EXPECT_TRUE(
      means("Start: 0 Acceptance: 1 Fin(0) properties: very-weak --BODY-- "
            "State: 0 [!0] 0 [0] 0&1 State: 1 {0} [!1] 1 [1] 2 State: 2 [t] 2",
            "G (a -> X F b)"))
      << "weak co-Büchi, as translations to very weak alternating automata print it";
  EXPECT_TRUE(means("Start: 0 Acceptance: 0 t --BODY-- State: 0 [0] 0&1 State: 1 [1] 1", "G a & X G b"));
}

TEST(OmegaHoa, RefusesWhatItCannotRead) {
  const auto refuses = [](const std::string& text, const std::string& message) {
    try {
      read_omega_hoa(text);
      ADD_FAILURE() << text;
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  refuses("HOA: v1 Acceptance: 65 Inf(64) --BODY-- --END--", "at most 64 acceptance sets");
  refuses("HOA: v1 Acceptance: 64 Inf(!3) --BODY-- --END--", "at most 64 acceptance sets");
  refuses("HOA: v1 Start: 0&1 Acceptance: 1 Fin(0) --BODY-- State: 0 [t] 0 {0} [t] 0 --END--",
          "universal branches are removed from automata that are weak or have Büchi acceptance");
  refuses("HOA: v1 --ABORT--", "aborted");
}

// What the text says of determinism, completeness and marks, against every state and letter.
void expect_true_claims(const HoaAutomaton& file, const Automaton& automaton) {
  const auto claims = [&](std::string_view property) {
    return std::any_of(file.properties.begin(), file.properties.end(),
                       [&](const HoaToken& token) { return token.text == property; });
  };
  std::size_t fewest = SIZE_MAX, most = 0;
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    testing::for_each_trace({.length = 1, .atoms = 2}, [&](const ltl::Trace& word) {
      const std::size_t branches = automaton.next(StateId{q}, word[0]).size();
      fewest = std::min(fewest, branches);
      most = std::max(most, branches);
    });
  EXPECT_EQ(claims("complete"), fewest > 0);
  EXPECT_EQ(claims("deterministic"), most <= 1);
  EXPECT_NE(claims("state-acc"), claims("trans-acc"));
  for (const HoaAutomaton::State& state : file.states) {
    EXPECT_TRUE(claims("state-acc") || state.marks.empty());
    for (const HoaAutomaton::Edge& edge : state.edges) EXPECT_TRUE(claims("trans-acc") || edge.marks.empty());
  }
}

TEST(OmegaHoa, WhatIsWrittenIsReadBack) {
  ltl::Random random(21);
  for (int i = 0; i < 300; ++i) {
    const Automaton a = random_automaton(
        random, ab, {.states = static_cast<std::uint32_t>(1 + i % 5), .sets = static_cast<std::uint32_t>(i % 4)});
    for (const bool flag : {false, true}) {
      const std::string text =
          write_hoa(a, {.name = "a \"name\"", .marks_on_states = flag, .layout = {.aliases = flag, .one_line = flag}});
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n') == 1, flag) << text;
      HoaAutomaton file = parse_hoa(text, "");
      EXPECT_EQ(file.name, "a \"name\"");
      expect_true_claims(file, a);
      Budget budget;
      const Automaton b = to_automaton(std::move(file), "", budget);
      EXPECT_EQ(write_hoa(b), write_hoa(a)) << text;
    }
  }
}

TEST(OmegaHoa, MarksStandOnStatesWhereTheyCan) {
  const Automaton a = read_omega_hoa(
      "HOA: v1 Start: 0 AP: 1 \"a\" Acceptance: 1 Inf(0) --BODY-- State: 0 [0] 1 {0} [!0] 0 {0} State: 1 [t] "
      "1 --END--");
  const std::string text = write_hoa(a, {.marks_on_states = true});
  EXPECT_NE(text.find("state-acc"), std::string::npos);
  EXPECT_NE(text.find("State: 0 {0}\n"), std::string::npos) << text;
}

TEST(OmegaHoa, EdgesAreCountedBeforeTheyAreWritten) {
  ltl::Random random(22);
  const Automaton a = random_automaton(random, ab, {.states = 5, .empty = 0});
  EXPECT_FALSE(write_hoa_within(a, 3).has_value());
  EXPECT_TRUE(write_hoa_within(a, 1'000).has_value());
  // One edge whose label has 2^19 cubes: as many letters as an odd number of 20 propositions.
  std::vector<std::string> names;
  for (int p = 0; p < 20; ++p) names.push_back("p" + std::to_string(p));
  TransitionRelation parity;
  const auto loop = parity.choices.intern({{0, Marks()}});
  Mtbdd::Node even = Mtbdd::terminal(Choices::none), odd = Mtbdd::terminal(loop);
  std::vector<ltl::Proposition> reads;
  for (std::uint32_t v = 20; v-- > 0;) {
    const Mtbdd::Node e = parity.diagram.make(v, even, odd), o = parity.diagram.make(v, odd, even);
    even = e;
    odd = o;
  }
  for (std::uint32_t p = 0; p < 20; ++p) reads.push_back({p});
  parity.roots = {even};
  EXPECT_FALSE(write_hoa_within(Automaton(ltl::Vocabulary(names), reads, parity), 10'000).has_value());
}

}  // namespace
}  // namespace waymark::automata
