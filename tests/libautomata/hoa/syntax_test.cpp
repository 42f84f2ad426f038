// Every construct of HOA v1, right and wrong, as it is written; what it means is tested where it is used.
#include "libautomata/hoa/syntax.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"

namespace waymark::automata {
namespace {

using Op = HoaCondition::Op;

std::string show(const HoaCondition& c) {
  if (c.op == Op::True || c.op == Op::False) return c.op == Op::True ? "t" : "f";
  if (c.op == Op::Inf || c.op == Op::Fin)
    return (c.op == Op::Inf ? "I" : "F") + std::string(c.complemented ? "!" : "") + std::to_string(c.set);
  std::string out;
  for (const HoaCondition& operand : c.operands)
    out += (out.empty() ? "(" : c.op == Op::And ? "&" : "|") + show(operand);
  return out + ")";
}

TEST(HoaSyntax, ReadsAlternation) {
  const HoaAutomaton a = parse_hoa(R"(HOA: v1 Start: 0&2 Start: 1 States: 3 AP: 1 "a" Acceptance: 1 Fin(0)
    properties: univ-branch --BODY-- State: 0 [0] 1&2 {0} State: 1 [t] 1 State: 2 --END--)",
                                   "");
  EXPECT_EQ(a.starts, (std::vector<std::vector<std::uint64_t>>{{0, 2}, {1}}));
  EXPECT_EQ(a.states[0].edges[0].targets, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(a.states[0].edges[0].marks, (std::vector<std::uint64_t>{0}));
  EXPECT_TRUE(a.states[2].edges.empty());
}

TEST(HoaSyntax, ReadsAcceptance) {
  const auto acceptance = [](const std::string& text) {
    return show(parse_hoa("HOA: v1 Acceptance: " + text + " --BODY-- --END--", "").acceptance);
  };
  EXPECT_EQ(acceptance("0 t"), "t");
  EXPECT_EQ(acceptance("0 f"), "f");
  EXPECT_EQ(acceptance("4 Inf(0)&Fin(1)|Inf(!2)&(Fin(!3)|t)"), "((I0&F1)|(I!2&(F!3|t)))");
  EXPECT_EQ(acceptance("3 Inf(0)|Inf(1)|Inf(2)"), "(I0|I1|I2)");
  EXPECT_EQ(acceptance("3 ((Inf(0)))&Inf(1)"), "(I0&I1)");
}

TEST(HoaSyntax, ReadsNamesAndWhereLabelsStand) {
  const HoaAutomaton a = parse_hoa(R"(HOA: v1 name: "an \"automaton\" \\" tool: "t" "1" States: 3
    acc-name: generalized-Buchi 2 AP: 1 "a" Start: 0 Acceptance: 2 Inf(0)&Inf(1)
    unknown: t f 3 "text" word  properties: a b  properties: c --BODY--
    State: 0 "zero" {0 1} 1 2 State: [0] 1 {} 1 State: 2 [0] 1 [!0] 2 {1}--END--)",
                                   "");
  EXPECT_EQ(a.name, "an \"automaton\" \\");
  EXPECT_EQ(a.properties.size(), 3U);
  EXPECT_EQ(a.states[0].name, "zero");
  EXPECT_EQ(a.states[0].marks, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(a.states[0].labels, HoaAutomaton::Labels::Implied);
  EXPECT_EQ(a.states[1].labels, HoaAutomaton::Labels::State);
  EXPECT_EQ(a.states[2].labels, HoaAutomaton::Labels::Edge);
}

TEST(HoaSyntax, ReadsStreams) {
  const std::string first = "HOA: v1 Acceptance: 0 t --BODY-- --END-- /* between */ ";
  const std::string text = first + "HOA: v1 name: \"cut\" AP: 3 \"a\" --ABORT-- " + "HOA: v1 --ABORT--" +
                           "HOA: v1 Acceptance: 0 t --BODY-- State: 0 [t --ABORT-- " + first;
  HoaReader reader(text, "");
  EXPECT_FALSE(reader.next()->aborted);
  EXPECT_TRUE(reader.next()->aborted);
  EXPECT_TRUE(reader.next()->aborted);
  EXPECT_TRUE(reader.next()->aborted);
  EXPECT_FALSE(reader.next()->aborted);
  EXPECT_FALSE(reader.next().has_value());
  EXPECT_FALSE(reader.next().has_value());
}

TEST(HoaSyntax, ReadsOnBehindAWrongAutomaton) {
  HoaReader reader("HOA: v1 Acceptance: 0 nonsense --BODY-- --END-- HOA: v1 Acceptance: 0 t --BODY-- --END--", "");
  EXPECT_THROW(reader.next(), ltl::FormatError);
  EXPECT_TRUE(reader.next().has_value());
  EXPECT_FALSE(reader.next().has_value());
  HoaReader broken("HOA: v1 $ --END-- HOA: v1 Acceptance: 0 t --BODY-- --END--", "");
  EXPECT_THROW(broken.next(), ltl::FormatError);
  EXPECT_FALSE(broken.next().has_value());
}

TEST(HoaSyntax, PointsAtWhatIsWrong) {
  const struct {
    const char* text;
    std::size_t line, column;
    const char* message;
  } table[] = {
      {"HOA: v1\nStart: 2\nStates: 2\nAcceptance: 0 t\n--BODY--\n--END--", 2, 8, "state 2 of 2"},
      {"HOA: v1\nname: word\n", 2, 7, "expected the name of the automaton in quotes, not 'word'"},
      {"HOA: v1\ntool: 3\n", 2, 7, "expected the name of a tool in quotes"},
      {"HOA: v1\ntool: \"a\" \"b\" \"c\"\n", 2, 15, "expected a header or --BODY--"},
      {"HOA: v1\nacc-name: 3\n", 2, 11, "expected the name of an acceptance condition"},
      {"HOA: v1\nunknown: [3]\n", 2, 10, "expected a header or --BODY--, not '['"},
      {"HOA: v1\nproperties: \"deterministic\"\n", 2, 13, "expected a header or --BODY--"},
      {"HOA: v1\nStart: 0&\n", 3, 1, "expected the number of a state"},
      {"HOA: v1\nHOA: v1\n", 2, 1, "a second header 'HOA:'"},
      {"HOA: v1\nAcceptance: 1 Inf(0)&\n--BODY--", 3, 1, "expected an acceptance condition"},
      {"HOA: v1\nAcceptance: 1 (Inf(0)\n--BODY--", 3, 1, "expected ')'"},
      {"HOA: v1\nAcceptance: 1 Inf 0\n", 2, 19, "expected '(', not '0'"},
      {"HOA: v1\nAP: 1 \"a\" Alias: @a 0 Alias: @a 0 Acceptance: 0 t\n--BODY--\n--END--", 2, 30, "a second alias '@a'"},
      {"HOA: v1\nAP: 1 \"a\" Alias: @b @a Alias: @a 0 Acceptance: 0 t\n--BODY--\n--END--", 2, 21, "unknown alias '@a'"},
      {"HOA: v1\nAP: 1 \"a\" Acceptance: 0 t\n--BODY--\nState: 0&1\n--END--", 4, 8, "expected the number of one state"},
  };
  for (const auto& row : table) {
    try {
      HoaReader(row.text, "").next();
      ADD_FAILURE() << "was read: " << row.text;
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what() << row.text;
      EXPECT_EQ(error.line(), row.line) << error.what() << "\n" << row.text;
      EXPECT_EQ(error.column(), row.column) << error.what() << "\n" << row.text;
    }
  }
}

}  // namespace
}  // namespace waymark::automata
