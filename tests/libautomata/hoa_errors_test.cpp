// What the HOA reader refuses, where it points, and that no text makes it fail in any other way.
#include <gtest/gtest.h>

#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::automata {
namespace {

constexpr std::string_view head = "HOA: v1\nStart: 0\nAP: 2 \"a\" \"b\"\nAcceptance: 1 Inf(0)\n--BODY--\n";

TEST(ReadHoa, PointsAtWhatIsWrong) {
  const struct {
    std::string text;
    std::size_t line, column;
    const char* message;
  } table[] = {
      {"", 1, 1, "expected 'HOA: v1' at the beginning, not the end of the file"},
      {"HOA: v2\n", 1, 6, "HOA versions v1 and v1.1 are read"},
      {"HOA: v1\n--BODY--\n--END--\n", 2, 1, "'Acceptance:' is missing"},
      {"HOA: v1\nStates: 1\nStates: 1\n", 3, 1, "a second header 'States:'"},
      {"HOA: v1\nColour: 3\n", 2, 1, "unknown header 'Colour:'"},
      {"HOA: v1\nAP: 2 \"a\"\nAcceptance: 0 t\n", 2, 5, "announces 2 propositions and names 1"},
      {"HOA: v1\nAP: 1000000000\nAcceptance: 0 t\n", 2, 5, "announces 1000000000 propositions and names 0"},
      {"HOA: v1\nAP: 2 \"ä\" \"ä\"\n", 2, 11, "a second proposition '\"ä\"'"},
      {"HOA: v1\nAcceptance: 1 Inf(1)\n", 2, 19, "acceptance set 1 of 1"},
      {"HOA: v1\nAcceptance: 1 Max(0)\n", 2, 15, "expected Inf, Fin, t or f"},
      {"HOA: v1\nStart: 0\nAcceptance: 2 Inf(0)&Inf(1)\n--BODY--\n--END--", 3, 1, "the acceptance of a DFA is Büchi"},
      {"HOA: v1\nStart: 0\nAcceptance: 1 Fin(0)\n--BODY--\n--END--", 3, 1, "the acceptance of a DFA is Büchi"},
      {"HOA: v1\nStart: 0\nStart: 1\nAcceptance: 0 t\n--BODY--\n--END--", 3, 1, "several initial states"},
      {"HOA: v1\nStart: 0&1\nAcceptance: 0 t\n--BODY--\n--END--", 0, 0, "alternating automata are no DFAs"},
      {"HOA: v1\nStates: 2\nStart: 2\n", 3, 8, "state 2 of 2"},
      {"HOA: v1\nAlias: a 0\n", 2, 8, "expected the name of an alias, as @a, not 'a'"},
      {"HOA: v1\nAlias: @a @b\nAP: 1 \"a\"\nAcceptance: 0 t\n--BODY--\n--END--", 2, 11, "unknown alias '@b'"},
      {"HOA: v1\nAP: 1 \"a\nAcceptance", 2, 7, "this string does not end"},
      {"HOA: v1 /* open", 1, 9, "this comment does not end"},
      {"HOA: v1\nStates: 007\n", 2, 10, "a number does not begin with 0"},
      {"HOA: v1\nStates: 99999999999999999999\n", 2, 27, "this number is too large"},
      {"HOA: v1 $", 1, 9, "this character has no place"},
      {std::string(head) + "State: 0 [2] 0\n--END--", 6, 11, "proposition 2 of 2"},
      {std::string(head) + "State: 0 [0 1] 0\n--END--", 6, 13, "expected ']', not '1'"},
      {std::string(head) + "State: 0 [0&] 0\n--END--", 6, 13, "expected a proposition's number"},
      {std::string(head) + "State: 0 [0] 0\n[!1] 1\n--END--", 7, 1, "nondeterministic"},
      {std::string(head) + "State: 0 [t] 0&1\n--END--", 6, 10, "a universal branch"},
      {std::string(head) + "State: 0 0 1 1\n--END--", 6, 1, "one edge per letter, 2^2, not 3"},
      {std::string(head) + "State: 0 [0] 0 1\n--END--", 6, 1, "some edges of this state have labels"},
      {std::string(head) + "State: [t] 0 [0] 0\n--END--", 6, 14, "a label on an edge of a state that has a label"},
      {std::string(head) + "State: 0 {1} [t] 0\n--END--", 6, 11, "acceptance set 1 of 1"},
      {std::string(head) + "State: 0 [t] 0\nState: 0 [t] 0\n--END--", 7, 8, "state 0 is defined a second time"},
      {std::string(head) + "State: 0 [t] 0\n--ABORT--", 7, 1, "the automaton was aborted"},
      {std::string(head) + "State: 0 [t] 0\n", 7, 1, "expected 'State:', an edge or --END--, not the end of the file"},
      {std::string(head) + "State: 0 [t] 0\n--END--\nHOA: v1", 8, 1, "one automaton is read"},
  };
  for (const auto& row : table) {
    try {
      read_hoa(row.text, "wrong.hoa");
      ADD_FAILURE() << "was read: " << row.text;
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what() << "\n" << row.text;
      EXPECT_NE(std::string(error.what()).find("wrong.hoa"), std::string::npos) << error.what();
      EXPECT_EQ(error.line(), row.line) << error.what() << "\n" << row.text;
      EXPECT_EQ(error.column(), row.column) << error.what() << "\n" << row.text;
    }
  }
}

TEST(ReadHoa, NumbersInTheTextDoNotCostMemory) {
  const Dfa dfa = read_hoa(
      "HOA: v1\nStates: 4000000000\nStart: 3999999999\nAP: 0\nAcceptance: 1 Inf(0)\n--BODY--\n"
      "State: 3999999999 [t] 17\nState: 17 {0}\n--END--");
  EXPECT_EQ(dfa.states(), 3U) << "the two that occur, and a trap";
}

TEST(ReadHoa, PropositionsAreLimited) {
  std::string names;
  for (int i = 0; i < 17'000; ++i) names += " \"p" + std::to_string(i) + '"';
  EXPECT_THROW(read_hoa("HOA: v1\nAP: 17000" + names + "\nAcceptance: 0 t\n--BODY--\n--END--"), ltl::FormatError);
}

TEST(ReadHoa, NestingIsLimited) {
  for (const char* open : {"(", "!"}) {
    std::string label;
    for (int i = 0; i < 100'000; ++i) label += open;
    EXPECT_THROW(read_hoa(std::string(head) + "State: 0 [" + label + "0] 0\n--END--"), ltl::FormatError);
  }
  std::string deep = "HOA: v1 Acceptance: 1 ";
  for (int i = 0; i < 100'000; ++i) deep += '(';
  EXPECT_THROW(read_hoa(deep), ltl::FormatError);
}

// Whatever is done to a text, it is read or refused with a FormatError; what is read is a complete automaton.
TEST(ReadHoa, SurvivesDamagedTexts) {
  ltl::Random random(31);
  ltl::Arena arena;
  const std::string good = write_hoa(ltlf_to_dfa(ltl::parse("G (a -> X (b U c)) & F d", arena)));
  const std::string_view spare = "0123456789[]{}()!&|@\"\\:-_ tfaZ\n/*";
  std::size_t read = 0, refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = good;
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      const std::size_t at = random.below(text.size()), length = random.below(6);
      const std::size_t kind = random.below(3);
      if (kind == 0) text.erase(at, length);
      if (kind == 1) text.insert(at, 1, spare[random.below(spare.size())]);
      if (kind == 2) text.insert(at, text.substr(random.below(text.size()), length));
    }
    try {
      const Dfa dfa = read_hoa(text);
      dfa.next(dfa.initial(), {});
      ++read;
    } catch (const ltl::FormatError&) {
      ++refused;
    }
  }
  EXPECT_GT(read, 100U);
  EXPECT_GT(refused, 100U);
}

}  // namespace
}  // namespace waymark::automata
