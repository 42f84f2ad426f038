// HOA texts right in every construct that a DFA may use, and what they mean.
#include "libautomata/hoa/finite.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/places.hpp"

namespace waymark::automata {
namespace {

Dfa translate(std::string_view text, const std::vector<std::string>& names = {}) {
  ltl::Arena arena{ltl::Vocabulary(names)};
  return ltlf_to_dfa(ltl::parse(text, arena));
}

::testing::AssertionResult means(std::string_view hoa, std::string_view formula) {
  const std::optional<Difference> found = difference(read_hoa(hoa), translate(formula));
  if (!found) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "differs from " << formula << " on "
                                       << ltl::show(found->word, found->vocabulary);
}

TEST(WriteHoa, IsStableAndStatesItsConvention) {
  EXPECT_EQ(write_hoa(translate("F (a & b)"), {.name = "F (a & b)"}),
            "HOA: v1\n"
            "name: \"F (a & b)\"\n"
            "tool: \"waymark\"\n"
            "States: 2\n"
            "Start: 0\n"
            "AP: 2 \"a\" \"b\"\n"
            "acc-name: Buchi\n"
            "Acceptance: 1 Inf(0)\n"
            "properties: trans-labels explicit-labels state-acc complete deterministic finite-words\n"
            "--BODY--\n"
            "State: 0\n"
            "[!0 | !1] 0\n"
            "[0&1] 1\n"
            "State: 1 {0}\n"
            "[t] 1\n"
            "--END--\n");
}

TEST(WriteHoa, IsWhatTheDocumentShows) {
  std::ifstream in(testing::source_root() / "docs" / "formats" / "hoa.md");
  const std::string document{std::istreambuf_iterator<char>(in), {}};
  const std::string shown = "```\n" + write_hoa(translate("F (a & b)"), {.name = "F (a & b)"}) + "```";
  EXPECT_NE(document.find(shown), std::string::npos) << "docs/formats/hoa.md does not show\n" << shown;
}

TEST(WriteHoa, EscapesNames) {
  ltl::Arena arena;
  const Dfa dfa = ltlf_to_dfa(ltl::eventually(arena.atom("a \"b\" \\ c")));
  EXPECT_NE(write_hoa(dfa).find(R"("a \"b\" \\ c")"), std::string::npos) << write_hoa(dfa);
  EXPECT_EQ(read_hoa(write_hoa(dfa)).vocabulary().name({0}), "a \"b\" \\ c");
}

TEST(ReadHoa, MarksOnStatesSayWhereTheWordMayStop) {
  EXPECT_TRUE(means(R"(HOA: v1 States: 2 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0) --BODY--
    State: 0 [!0] 0 [0] 1 State: 1 {0} [t] 1 --END--)",
                    "F a"));
}

TEST(ReadHoa, MarksOnEdgesSayAfterWhichLetter) {
  EXPECT_TRUE(means(R"(HOA: v1 States: 1 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0) properties: trans-acc --BODY--
    State: 0 [!0] 0 [0] 0 {0} --END--)",
                    "F (a & N false)"));
}

TEST(ReadHoa, AMarkOnTheInitialStateCountsOnReturnOnly) {
  EXPECT_TRUE(means(R"(HOA: v1 States: 2 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0) --BODY--
    State: 0 {0} [0] 0 [!0] 1 State: 1 [t] 1 --END--)",
                    "G a"));
}

TEST(ReadHoa, HeadersComeInAnyOrderAndUnknownOnesAreSkipped) {
  EXPECT_TRUE(means(R"(HOA: v1
    /* a comment /* in a comment */ */
    AP: 2 "b" "a"   Acceptance: 1 (Inf(0))  acc-name: Buchi 3 x
    tool: "someone" "1.0" name: "F a" properties: deterministic complete
    some-tool: 1 t "text" 2  Start: 7
    --BODY-- State: 7 "first" [!1] 7 [1] 3 State: 3 "second" {0} [t] 3 --END--)",
                    "F a"));
}

TEST(ReadHoa, AliasesMayUseEarlierAliases) {
  EXPECT_TRUE(means(R"(HOA: v1 Alias: @a 0 Alias: @ab @a & (1 | 1) Alias: @rest !@ab Start: 0 AP: 2 "a" "b"
    Acceptance: 1 Inf(0) --BODY-- State: 0 [@rest] 0 [@ab] 1 State: 1 {0} [t] 1 --END--)",
                    "F (a & b)"));
}

TEST(ReadHoa, LabelsMayBeImpliedOrSitOnStates) {
  EXPECT_TRUE(means(R"(HOA: v1 Start: 0 AP: 2 "a" "b" Acceptance: 1 Inf(0) --BODY--
    State: 0 0 0 0 1 State: 1 {0} 1 1 1 1 --END--)",
                    "F (a & b)"));
  EXPECT_TRUE(means(R"(HOA: v1 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0) --BODY--
    State: [t] 0 1 State: [0] 1 {0} 1 --END--)",
                    "N G a"));
}

TEST(ReadHoa, MissingLettersLeadToATrap) {
  const Dfa dfa = read_hoa(R"(HOA: v1 States: 2 Start: 0 AP: 1 "a" Acceptance: 1 Inf(0) --BODY--
    State: 0 [0] 1 State: 1 {0} --END--)");
  EXPECT_EQ(dfa.states(), 3U);
  EXPECT_TRUE(dfa.is_trap(StateId{2}));
  EXPECT_FALSE(difference(dfa, translate("a & N false")).has_value());
}

TEST(ReadHoa, OtherAcceptanceThatADfaMayHave) {
  EXPECT_TRUE(means(R"(HOA: v1 Start: 0 AP: 1 "a" Acceptance: 0 t --BODY-- State: 0 [0] 0 --END--)", "G a"))
      << "every run is accepting: only missing edges reject";
  EXPECT_TRUE(means(R"(HOA: v1 Start: 0 AP: 1 "a" Acceptance: 0 f --BODY-- State: 0 [t] 0 --END--)", "false"));
  EXPECT_TRUE(means(R"(HOA: v1 Start: 0 AP: 1 "a" Acceptance: 2 Inf(1) --BODY--
    State: 0 {0} [!0] 0 [0] 1 State: 1 {1} [t] 1 --END--)",
                    "F a"))
      << "the set that the condition names counts";
  EXPECT_TRUE(means(R"(HOA: v1 AP: 0 Acceptance: 1 Inf(0) --BODY-- --END--)", "false")) << "no initial state";
}

TEST(ReadHoa, LabelsThatOverlapOnOneTargetAreNoNondeterminism) {
  EXPECT_TRUE(means(R"(HOA: v1 Start: 0 AP: 2 "a" "b" Acceptance: 1 Inf(0) --BODY--
    State: 0 [0] 1 [1] 1 [!0&!1] 0 State: 1 {0} [t] 1 --END--)",
                    "F (a | b)"));
}

TEST(ReadHoa, KeepsStateNumbersAndPropositionOrder) {
  const Dfa dfa = read_hoa(R"(HOA: v1 States: 3 Start: 2 AP: 3 "z" "unused" "a" Acceptance: 1 Inf(0) --BODY--
    State: 0 {0} [t] 0 State: 1 [t] 1 State: 2 [0&2] 0 [!0&2] 1 [!2] 2 --END--)");
  EXPECT_EQ(dfa.initial(), StateId{2});
  EXPECT_TRUE(dfa.is_accepting(StateId{0}));
  EXPECT_TRUE(dfa.is_trap(StateId{1}));
  EXPECT_EQ(dfa.vocabulary().names(), (std::vector<std::string>{"z", "unused", "a"}));
  EXPECT_EQ(dfa.reads(), (std::vector<ltl::Proposition>{{0}, {2}}));
}

}  // namespace
}  // namespace waymark::automata
