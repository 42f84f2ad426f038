#include "libautomata/hoa/dot_finite.hpp"

#include <gtest/gtest.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::automata {
namespace {

Dfa translate(std::string_view text) {
  ltl::Arena arena;
  return ltlf_to_dfa(ltl::parse(text, arena));
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Dot, DrawsStatesAndGuards) {
  const std::string dot = write_dot(translate("F (a & b)"));
  EXPECT_TRUE(contains(dot, "rankdir=LR")) << dot;
  EXPECT_TRUE(contains(dot, "start -> 0;")) << dot;
  EXPECT_TRUE(contains(dot, "1 [shape=doublecircle]")) << dot;
  EXPECT_TRUE(contains(dot, "0 -> 1 [label=\"a ∧ b\"]")) << dot;
  EXPECT_TRUE(contains(dot, "0 -> 0 [label=\"¬(a ∧ b)\"]")) << dot;
}

TEST(Dot, GreysOrOmitsTheTrap) {
  const Dfa dfa = translate("a U b");
  EXPECT_TRUE(contains(write_dot(dfa), "gray70"));
  const std::string without = write_dot(dfa, {.trap = DotOptions::Trap::Omit});
  EXPECT_FALSE(contains(without, "gray70")) << without;
  EXPECT_FALSE(contains(without, "¬a ∧ ¬b")) << "the edge into the trap goes with it: " << without;
  EXPECT_TRUE(contains(without, "0 -> 0 [label=\"a ∧ ¬b\"]")) << without;
}

TEST(Dot, AnEmptyLanguageStillShowsItsInitialState) {
  const std::string dot = write_dot(translate("false"), {.trap = DotOptions::Trap::Omit});
  EXPECT_TRUE(contains(dot, "start -> 0;")) << dot;
  EXPECT_TRUE(contains(dot, "  0 [color=gray70")) << dot;
}

TEST(Dot, EscapesAndBreaksLongLabels) {
  ltl::Arena arena;
  const ltl::Formula odd = arena.atom("say \"hi\" \\ there");
  const std::string escaped = write_dot(ltlf_to_dfa(ltl::eventually(odd)));
  EXPECT_FALSE(contains(escaped, "label=\"\"say")) << escaped;
  const std::string wide = write_dot(
      translate("F (ahead_chair & left_brick & behind_fish | right_wall & ahead_open & tee)"), {.label_width = 20});
  EXPECT_TRUE(contains(wide, "\\n∨ ")) << wide;
}

}  // namespace
}  // namespace waymark::automata
