#include "libparser/programs/program.hpp"

#include <gtest/gtest.h>

#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

class Programs : public ::testing::Test {
 protected:
  Step step(StepKind kind, std::vector<std::string> literals) const {
    Step s{kind, 0, static_cast<std::uint8_t>(literals.size()), {}};
    for (std::size_t i = 0; i < literals.size(); ++i)
      s.goal[i] = static_cast<std::uint16_t>(arena.vocabulary().find(literals[i]).value().index);
    return s;
  }
  static Step forward(std::uint8_t k) { return {StepKind::Forward, k, 0, {}}; }
  static Step bare(StepKind kind) { return {kind, 0, 0, {}}; }

  ltl::Arena arena{shipped_maps().front().vocabulary()};
};

TEST_F(Programs, MacrosAreTheFormulasOfTheConventions) {
  const std::pair<Program, const char*> table[] = {
      {{bare(StepKind::Stay)}, "true"},
      {{step(StepKind::Reach, {"chair"})}, "F chair"},
      {{step(StepKind::Reach, {"chair", "ahead_wall"})}, "F (chair & ahead_wall)"},
      {{step(StepKind::Next, {"turned_left"})}, "X turned_left"},
      {{forward(1)}, "X moved"},
      {{forward(3)}, "X (moved & X (moved & X moved))"},
      {{step(StepKind::Advance, {"lamp"})}, "X (moved U (moved & lamp))"},
      {{step(StepKind::Face, {"ahead_blue"})},
       "X ((turned_left | turned_right) U ((turned_left | turned_right) & ahead_blue))"},
  };
  for (const auto& [program, text] : table)
    EXPECT_EQ(formula_of(program, arena), ltl::parse(text, arena)) << ltl::print(formula_of(program, arena));
}

TEST_F(Programs, ThenNestsTheRestWhereTheGoalHolds) {
  const std::pair<Program, const char*> table[] = {
      {{step(StepKind::Reach, {"chair"}), step(StepKind::Reach, {"lamp"})}, "F (chair & F lamp)"},
      {{forward(2), step(StepKind::Next, {"turned_right"})}, "X (moved & X (moved & X turned_right))"},
      {{step(StepKind::Next, {"turned_left"}), forward(1), step(StepKind::Reach, {"sofa"})},
       "X (turned_left & X (moved & F sofa))"},
      {{step(StepKind::Advance, {"lamp"}), forward(1)}, "X (moved U (moved & lamp & X moved))"},
      {{bare(StepKind::Orient), forward(1)},
       "X moved | X ((turned_left | turned_right) U ((turned_left | turned_right) & X moved))"},
  };
  for (const auto& [program, text] : table)
    EXPECT_EQ(formula_of(program, arena), ltl::parse(text, arena)) << ltl::print(formula_of(program, arena));
}

TEST_F(Programs, FunctionsApplyToTheStepsAfterThem) {
  const Step chair = step(StepKind::Reach, {"chair"}), left = step(StepKind::Next, {"turned_left"}),
             lamp = step(StepKind::Reach, {"lamp"});
  Step second = step(StepKind::Advance, {"tee"});
  second.count = 2;
  const std::pair<Program, const char*> table[] = {
      {{step(StepKind::Without, {"sofa"}), chair}, "!sofa U chair"},
      {{step(StepKind::Without, {"sofa"}), chair, lamp}, "!sofa U (chair & F lamp)"},
      {{step(StepKind::Keep, {"blue"}), chair}, "blue U chair"},
      {{step(StepKind::Keep, {"blue"}), forward(2), left}, "blue & X (moved & blue & X (moved & X turned_left))"},
      {{step(StepKind::Without, {"sofa"}), step(StepKind::Advance, {"lamp"})},
       "!sofa & X ((moved & !sofa) U (moved & lamp))"},
      {{step(StepKind::When, {"ahead_wall"}), left}, "(ahead_wall & X turned_left) | !ahead_wall"},
      {{step(StepKind::When, {"ahead_wall"}), left, lamp},
       "(ahead_wall & X (turned_left & F lamp)) | (!ahead_wall & F lamp)"},
      {{forward(1), step(StepKind::Whether, {"tee"}), left, chair, lamp},
       "X (moved & ((tee & X (turned_left & F lamp)) | (!tee & F (chair & F lamp))))"},
      {{step(StepKind::Past, {"lamp"})}, "X (moved U (moved & lamp & X moved))"},
      {{second, left}, "X (moved U (moved & tee & X (moved U (moved & tee & X turned_left))))"},
  };
  for (const auto& [program, text] : table)
    EXPECT_EQ(formula_of(program, arena), ltl::parse(text, arena)) << ltl::print(formula_of(program, arena));
  EXPECT_THROW(formula_of({chair, step(StepKind::When, {"tee"})}, arena), std::invalid_argument);
}

TEST_F(Programs, MirroringExchangesSidesAndIsItsOwnInverse) {
  const auto images = mirror_images(arena.vocabulary());
  const Program program{step(StepKind::Next, {"turned_left"}), step(StepKind::Advance, {"left_chair"}), forward(2)};
  const Program image{step(StepKind::Next, {"turned_right"}), step(StepKind::Advance, {"right_chair"}), forward(2)};
  EXPECT_EQ(mirror(program, images), image);
  std::mt19937_64 random(1);
  const PostfixGrammar grammar(arena.vocabulary());
  for (int i = 0; i < 200; ++i) {
    const Program p = random_program(grammar, random);
    EXPECT_EQ(mirror(mirror(p, images), images), p) << grammar.show(p);
  }
}

}  // namespace
}  // namespace waymark::parser
