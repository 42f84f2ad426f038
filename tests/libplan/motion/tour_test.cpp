#include "libplan/motion/realize_tour.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libplan/motion/terrains.hpp"

namespace waymark::plan {
namespace {

std::string word_text(const Motion& motion, const Terrain& terrain) {
  const auto read = word_of(motion, terrain);
  if (const auto* fault = std::get_if<NoTour>(&read)) return std::to_string(fault->step) + ": " + fault->reason;
  return ltl::show(ltl::Trace(std::get<TimedWord>(read).letters), terrain.vocabulary());
}

TEST(Tour, ReadsALetterForEveryChange) {
  const Terrain terrain = two_rooms();
  const struct {
    std::vector<Configuration> line;
    const char* word;
  } table[] = {
      {{{1, 1, 0}}, "{left}"},
      {{{1, 1, 0}, {2, 2, 0}}, "{left}"},
      {{{1, 1, 0}, {3.5, 2, 0}}, "{left}; {}"},
      {{{1, 2, 0}, {8, 2, 0}}, "{left}; {}; {right}"},
      {{{2, 2, 0}, {2, 3.5, 0}, {2, 2, 0}}, "{left}; {left, wet}; {left}"},
      {{{3, 1, 0}, {3.5, 1, 0}}, "{}"},  // on the border of a region: what holds for an instant is not read
      {{{1, 1, 0}, {8, 1, 0}}, "1: the robot touches a wall"},
      {{{0.1, 1, 0}}, "0: the robot does not fit where it starts"},
      {{{0.5, 2.5, 0}, {1.5, 3.5, 0}}, "1: the centre goes through a corner of regions"},
      {{{1, 1, 0}, {1, 1, 180}}, "1: half a turn at once: left or right?"},
      {{{1, 1, 400}}, "0: not a configuration: headings run from 0 to below 360"},
      {{}, "0: a motion needs at least one configuration"},
  };
  for (const auto& row : table) EXPECT_EQ(word_text({row.line, Disc{0.2}}, terrain), row.word);
}

// The exact crossings of an arc against its letters read point by point.
TEST(Tour, ReadsArcsAsTheirPointsSay) {
  const Terrain terrain = diamonds();
  std::size_t letters = 0;
  for (double heading = 0; heading < 360; heading += 7)
    for (const double turn : {-120.0, -40.0, 65.0, 170.0}) {
      const Configuration from{1.1, 2.7, heading};
      const Piece arc = Piece::driving(from, 1.1, turn);
      const Motion motion{{from, arc.at(1)}, Car{0.2, 0.1, 0.3}};
      const auto read = word_of(motion, terrain);
      if (!std::holds_alternative<TimedWord>(read)) continue;
      std::vector<ltl::Letter> expected;
      for (int k = 0; k < 4'000; ++k) {
        const ltl::Letter letter = terrain.label(position(arc.at((k + 0.5) / 4'000)));
        if (expected.empty() || !(expected.back() == letter)) expected.push_back(letter);
      }
      EXPECT_EQ(std::get<TimedWord>(read).letters, expected) << heading << " " << turn;
      letters += expected.size();
    }
  EXPECT_GT(letters, 60U);
}

struct Case {
  const char* formula;
  bool feasible;
};
constexpr Case cases[] = {
    {"F right", true},           {"F right & G !wet", true},
    {"F(right & F left)", true}, {"left & X(!left & X right)", true},
    {"F(wet & right)", true},    {"X X X right", true},
    {"X right", false},          {"F(left & right)", false},
    {"G left & F right", false}, {"right", false},
};

TEST(Tour, BothWaysGiveCertifiedToursOrProveThereIsNone) {
  const Terrain terrain = two_rooms();
  const Configuration start{1, 1, 90};
  std::size_t feasible = 0, explored = 0;
  for (const Robot& robot : {Robot(Disc{0.2}), Robot(Disc{0}), Robot(Car{0.6, 0.3, 0.4})})
    for (const Case& task : cases) {
      ltl::Arena arena(terrain.vocabulary());
      const ltl::Formula phi = ltl::parse(task.formula, arena);
      const automata::Dfa dfa = automata::ltlf_to_dfa(phi);
      const TourOutcome along = realize(dfa, terrain, start, {.iterations = 200, .robot = robot});
      EXPECT_EQ(std::holds_alternative<Motion>(along), task.feasible) << task.formula << " " << robot.index();
      EXPECT_EQ(std::holds_alternative<NoRun>(along), !task.feasible) << task.formula << " " << robot.index();
      const Explored by_tree = explore(dfa, terrain, start, {.seconds = 1, .robot = robot});
      EXPECT_EQ(std::holds_alternative<NoRun>(by_tree), !task.feasible) << task.formula << " " << robot.index();
      if (const auto* motion = std::get_if<Motion>(&along)) certify(*motion, terrain, phi);
      if (const auto* motion = std::get_if<Motion>(&by_tree)) {
        certify(*motion, terrain, phi);
        ++explored;
      }
      if (task.feasible) ++feasible;
    }
  EXPECT_GE(2 * explored, feasible);  // by the clock, so not all of them, always
}

TEST(Tour, TheSameSeedGivesTheSameBytes) {
  const Terrain terrain = diamonds();
  ltl::Arena arena(terrain.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F(b & !a)", arena));
  for (const Sampler sampler : {Sampler::InformedRrtStar, Sampler::BitStar})
    for (const Robot& robot : {Robot(Disc{0.2}), Robot(Car{0.6, 0.3, 0.4})}) {
      const Sampling sampling{.iterations = 500, .seed = 3, .robot = robot, .sampler = sampler};
      const auto first = realize(dfa, terrain, {1.2, 2.5, 90}, sampling),
                 again = realize(dfa, terrain, {1.2, 2.5, 90}, sampling);
      ASSERT_TRUE(std::holds_alternative<Motion>(first));
      EXPECT_EQ(std::get<Motion>(first), std::get<Motion>(again));
    }
}

TEST(Tour, ARobotTooWideForTheDoorProvesNothing) {
  const Terrain terrain = two_rooms();
  ltl::Arena arena(terrain.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F right", arena));
  const TourOutcome outcome = realize(dfa, terrain, {1, 1, 90}, {.iterations = 100, .robot = Disc{0.7}});
  EXPECT_TRUE(std::holds_alternative<NotFound>(outcome));
  const Explored explored = explore(dfa, terrain, {1, 1, 90}, {.robot = Disc{0.7}});
  ASSERT_TRUE(std::holds_alternative<OutOfTime>(explored));
  EXPECT_EQ(std::get<OutOfTime>(explored).seconds, 0);
}

TEST(Tour, CertifyRefusesAnotherWord) {
  const Terrain terrain = two_rooms();
  ltl::Arena arena(terrain.vocabulary());
  const Motion motion{{{1, 2, 0}, {8, 2, 0}}, Disc{0.2}};
  EXPECT_NO_THROW(certify(motion, terrain, ltl::parse("F right", arena)));
  EXPECT_THROW(certify(motion, terrain, ltl::parse("F wet", arena)), std::logic_error);
  EXPECT_THROW(certify({{{1, 1, 0}, {8, 1, 0}}, Disc{0.2}}, terrain, ltl::parse("true", arena)), std::logic_error);
}

}  // namespace
}  // namespace waymark::plan
