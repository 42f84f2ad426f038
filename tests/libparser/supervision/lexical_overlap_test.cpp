#include "libparser/supervision/lexical_overlap.hpp"

#include <gtest/gtest.h>

#include "libparser/corpus/token.hpp"
#include "libparser/lexicon/lexicon.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

class WordingTest : public ::testing::Test {
 protected:
  double lexical_overlap_penalty(const std::string& text, const Program& program) const {
    return Wording(model, mentions(tokenize(text))).lexical_overlap_penalty(program);
  }
  std::uint16_t p(const char* name) const {
    return static_cast<std::uint16_t>(model.vocabulary().find(name).value().index);
  }
  Step goal(StepKind kind, const char* literal) const { return {kind, 0, 1, {p(literal)}}; }
  static Step forward(std::uint8_t k) { return {StepKind::Forward, k, 0, {}}; }

  const ProgramLanguage model{shipped_maps().front().vocabulary()};
};

TEST_F(WordingTest, CountsWhatOneOfThemNamesAlone) {
  const Program turn{goal(StepKind::Next, "turned_left")}, chair{goal(StepKind::Reach, "chair")};
  const Program both{turn[0], chair[0]};
  EXPECT_EQ(lexical_overlap_penalty("turn left and walk to the chair", both), 0);
  EXPECT_EQ(lexical_overlap_penalty("turn left and walk to the chair", turn), Wording::missing);
  EXPECT_EQ(lexical_overlap_penalty("turn left", both), Wording::added);
  EXPECT_EQ(lexical_overlap_penalty("turn right", turn), Wording::missing + Wording::added);
  EXPECT_EQ(lexical_overlap_penalty("walk on", {}), 0);
}

TEST_F(WordingTest, DirectionsNameTheirSide) {
  EXPECT_EQ(lexical_overlap_penalty("stop with the chair to your left", {goal(StepKind::Reach, "left_chair")}), 0);
  EXPECT_EQ(lexical_overlap_penalty("stop with the chair to your left", {goal(StepKind::Reach, "right_chair")}),
            Wording::missing + Wording::added);
  EXPECT_EQ(lexical_overlap_penalty("stop with the chair ahead", {goal(StepKind::Reach, "ahead_chair")}), 0);
}

TEST_F(WordingTest, ANumberIsOneThing) {
  EXPECT_EQ(lexical_overlap_penalty("go two steps", {forward(2)}), 0);
  EXPECT_EQ(lexical_overlap_penalty("go to place 2", {goal(StepKind::Reach, "place_2")}), 0);
  EXPECT_EQ(lexical_overlap_penalty("go two steps", {forward(3)}), Wording::missing + Wording::added);
  EXPECT_EQ(lexical_overlap_penalty("take a step", {forward(1)}), 0);
  EXPECT_EQ(lexical_overlap_penalty("walk on", {goal(StepKind::Advance, "corridor")}),
            0);  // no word of the lexicon
}

}  // namespace
}  // namespace waymark::parser
