#include "libparser/ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/experiment/grounding_follower.hpp"
#include "libparser/model_file.hpp"
#include "libplan/plan_of.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

// With the shipped model, on sentences of our own.
class Ground : public ::testing::Test {
 protected:
  static const Grounder& model() {
    static const Grounder shipped =
        load_grounder(std::filesystem::path(WAYMARK_SOURCE_DIR) / "data" / "models" / "encoder-decoder.waymark");
    return shipped;
  }

  // The actions of the first reading's plan, one letter each.
  std::string actions(const std::string& text, const plan::Map& map, plan::Pose from) {
    const plan::PoseId start = map.find(from).value();
    const auto readings = ground(model(), text, map, {&start, 1}, arena);
    if (readings.empty()) return "?";
    const auto planned = plan::plan_of(map, readings.front().formula, start);
    const auto* const route = std::get_if<plan::CertifiedRoute>(&planned);
    if (route == nullptr) return "infeasible";
    std::string out;
    for (plan::Action a : route->route().actions) out += "FLR"[static_cast<std::size_t>(a)];
    return out;
  }

  ltl::Arena arena{shipped_maps().front().vocabulary()};
};

TEST_F(Ground, PlainInstructionsAreCarriedOut) {
  const plan::Map& grid = shipped_maps().front();
  const std::pair<const char*, const char*> table[] = {
      {"turn left", "L"},
      {"turn right", "R"},
      {"walk forward once", "F"},
      {"go forward two steps", "FF"},
      {"go forward two steps then turn right", "FFR"},
      {"walk forward three times and turn left", "FFFL"},
  };
  for (const auto& [text, want] : table) EXPECT_EQ(actions(text, grid, {1, 9, 0}), want) << text;
}

TEST_F(Ground, SentencesAreReadOneAfterTheOther) {
  EXPECT_EQ(actions("Turn right. Turn right. Turn left.", shipped_maps().front(), {1, 9, 0}), "RRL");
}

// All but the last sentence are read as a follower reads the paragraph.
TEST_F(Ground, WhatFollowsHasASayInWhatWentBefore) {
  const std::string texts[] = {
      "Walk to the lamp. Turn left. You should see a chair.",
      "Go forward. There is a sofa here. Take the blue hall to the easel.",
      "Face the brick hall. Go to the end of it. Turn right. Walk to the hatrack.",
      "Turn around. Move to the intersection. A chair is on your left.",
  };
  const GroundingFollower whole({model()}, {}), settling({model()}, {.paragraph = {.beam_width = 1}});
  std::size_t unsettled = 0, paragraphs = 0;
  for (const plan::Map& map : shipped_maps()) {
    const Executor executor(map);
    for (const std::string& text : texts)
      for (std::uint32_t pose = 0; pose < map.poses(); pose += testing::sanitized ? 160 : 48) {
        std::vector<SentenceInput> inputs;
        for (const std::string& sentence : split_sentences(text)) inputs.push_back({tokenize(sentence), false});
        const plan::PoseId start{pose};
        const auto answers = whole.follow_all(executor, inputs, start);
        Program want;
        for (std::size_t k = 0; k + 1 < answers.size(); ++k)
          for (const Step& step : answers[k].program)
            if (step.kind != StepKind::Stay) want.push_back(step);
        const auto readings = ground(model(), text, executor, {&start, 1}, arena);
        ASSERT_FALSE(readings.empty());
        const Program& got = readings.front().program;
        ASSERT_GE(got.size(), want.size());
        EXPECT_TRUE(std::equal(want.begin(), want.end(), got.begin())) << map.name() << ' ' << pose << ' ' << text;
        const auto settled = settling.follow_all(executor, inputs, start);
        unsettled += settled[settled.size() - 2].end != answers[answers.size() - 2].end ? 1U : 0U;
        ++paragraphs;
      }
  }
  EXPECT_GT(20 * unsettled, paragraphs);
}

TEST_F(Ground, ProbabilitiesSumToOneAndFormulasDiffer) {
  const plan::Map& grid = shipped_maps().front();
  const plan::PoseId start = grid.find({1, 9, 0}).value();
  const auto expect_distribution = [](const std::vector<Reading>& readings) {
    double total = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      total += readings[i].probability;
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(readings[i].formula, readings[j].formula);
    }
    EXPECT_NEAR(total, 1.0, 1e-6);
  };
  expect_distribution(ground(model(), "walk to the lamp", arena));
  expect_distribution(ground(model(), "walk to the lamp. turn left", arena));
  expect_distribution(ground(model(), "walk to the lamp", grid, {&start, 1}, arena));
}

TEST_F(Ground, NothingSaidGivesNoReadingAndTopIsKept) {
  EXPECT_TRUE(ground(model(), " ... ", arena).empty());
  EXPECT_EQ(ground(model(), "walk on", arena, {.beam = 16, .top = 3}).size(), 3U);
}

TEST_F(Ground, ChoosesTheEndThatCarriesMostProbability) {
  const plan::Map& grid = shipped_maps().front();
  const plan::PoseId start = grid.find({1, 9, 0}).value();
  const auto reading = [&](double probability, const Program& program) {
    return Reading{formula_of(program, arena), probability, program};
  };
  const auto left = static_cast<std::uint16_t>(grid.vocabulary().find("turned_left").value().index);
  const Program stay{Step{}}, turn{{StepKind::Next, 0, 1, {left}}}, reach{{StepKind::Reach, 0, 1, {left}}};
  const Reading readings[] = {reading(0.4, stay), reading(0.35, turn), reading(0.25, reach)};
  EXPECT_EQ(choose(readings, grid, {&start, 1}), 1U);  // 0.6 for the pose after a left turn
  EXPECT_EQ(choose({readings, 1}, grid, {&start, 1}), 0U);
}

TEST_F(Ground, AnUnknownHeadingIsASetOfStarts) {
  const plan::Map& grid = shipped_maps().front();
  std::vector<plan::PoseId> starts;
  for (int heading : {0, 90, 180, 270}) starts.push_back(grid.find({1, 9, heading}).value());
  EXPECT_FALSE(ground(model(), "walk forward twice", grid, starts, arena).empty());
  EXPECT_TRUE(ground(model(), "walk forward twice", grid, {}, arena).empty());
}

TEST_F(Ground, OtherVocabulariesAreRefused) {
  ltl::Arena other(ltl::Vocabulary({"chair", "moved"}));
  EXPECT_THROW(ground(model(), "turn left", other), ltl::FormatError);
}

}  // namespace
}  // namespace waymark::parser
