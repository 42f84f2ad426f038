// Generated maps: what is promised of every one of them, and street graphs read as models.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/model/formats/read_model.hpp"
#include "libplan/model/formats/read_streets.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/world/generate_hallways.hpp"
#include "libplan/world/read_map.hpp"
#include "tests/support/places.hpp"

namespace waymark::plan {
namespace {

std::string written(const GridRecipe& recipe) {
  std::ostringstream out;
  write_case(out, generate_grid(recipe));
  return out.str();
}

TEST(Generate, PutsLandmarksWithinReachPastNoHazard) {
  for (GridKind kind : all_grid_kinds)
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const GridRecipe recipe{kind, 23, 17, 4, 0, seed, true};
      const std::string text = written(recipe);
      const PlanningCase made = parse_case(text);
      for (const char* landmark : {"a", "b", "c", "d"}) {
        const CaseTask task{"", std::string("!x U ") + landmark, CaseTask::Logic::Ltl, CaseTask::Query::MinCost};
        EXPECT_EQ(answer(made, task).status, CaseAnswer::Status::Solved) << landmark << " of\n" << text;
      }
      for (const CaseTask& task : made.tasks) {
        if (kind == GridKind::OneWay && task.id != "seq") continue;  // no way back is promised
        EXPECT_NE(answer(made, task, {.explain = false}).status, CaseAnswer::Status::Exhausted) << task.id << " of\n"
                                                                                                << text;
      }
    }
}

TEST(Generate, GivesTheSameMapForTheSameSeed) {
  for (GridKind kind : all_grid_kinds) {
    const GridRecipe recipe{kind, 20, 20, 3, 0.05, 7, true};
    EXPECT_EQ(written(recipe), written(recipe));
    EXPECT_NE(written(recipe), written({kind, 20, 20, 3, 0.05, 8, true}));
  }
  EXPECT_EQ(generate_hallways({.seed = 3}), generate_hallways({.seed = 3}));
  EXPECT_NE(generate_hallways({.seed = 3}), generate_hallways({.seed = 4}));
}

TEST(Generate, SlipsToTheSidesAndBackAmongHazards) {
  const auto chances = [](GridKind kind) { return generate_grid({kind, 20, 20, 1, 0.125, 1, false}).motion; };
  EXPECT_EQ(chances(GridKind::Rooms), (SlipChances{0.75, 0.125, 0.125, 0}));
  EXPECT_EQ(chances(GridKind::Bridge), (SlipChances{0.625, 0.125, 0.125, 0.125}));
}

TEST(Generate, RefusesWhatCannotBe) {
  EXPECT_THROW(generate_grid({GridKind::Rooms, 2, 9, 1, 0, 1, false}), std::invalid_argument);
  EXPECT_THROW(generate_grid({GridKind::Rooms, 3, 3, 20, 0, 1, false}), std::invalid_argument);
  EXPECT_THROW(generate_grid({GridKind::Rooms, 9, 9, 21, 0, 1, false}), std::invalid_argument);
  EXPECT_THROW(generate_grid({GridKind::Scatter, 9, 9, 1, 0.4, 1, false}), std::invalid_argument);
  EXPECT_THROW(generate_hallways({.width = 1, .height = 1}), std::invalid_argument);
  EXPECT_THROW(generate_hallways({.width = 2, .height = 2, .objects = 5}), std::invalid_argument);
}

TEST(Generate, MakesHallwaysThatAreConnected) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Map map = parse_map(generate_hallways({.width = 7, .height = 5, .objects = 6, .seed = seed}));
    std::vector<bool> met(map.nodes().size());
    std::vector<std::uint32_t> open{0};
    met[0] = true;
    while (!open.empty()) {
      const std::uint32_t here = open.back();
      open.pop_back();
      for (int heading : {0, 90, 180, 270})
        if (const auto next = map.neighbour(here, heading); next && !met[*next]) {
          met[*next] = true;
          open.push_back(*next);
        }
    }
    EXPECT_EQ(std::count(met.begin(), met.end(), true), 35) << "seed " << seed;
  }
}

constexpr const char* two_ways =
    R"({"nodes": [{"id": 3, "name": "Blue Room"}, {"id": 5, "name": "Ashley's & Co."},
  {"id": 9, "name": "7-Eleven"}], "edges": [{"a": 3, "b": 5, "metres": 10.5}, {"a": 5, "b": 9, "metres": 2}]})";

TEST(Streets, AreChoicesThatCostMetres) {
  const Mdp streets = parse_streets(two_ways, "", "ashleys_co");
  EXPECT_EQ(streets.letters().vocabulary().names(), (std::vector<std::string>{"blue_room", "ashleys_co", "7_eleven"}));
  ASSERT_EQ(streets.initial(), 1U);
  ASSERT_EQ(streets.choices(1), 2U);
  EXPECT_EQ(streets.action(1, 1), "7_eleven");
  EXPECT_EQ(streets.cost(1, 0), 10.5);
  EXPECT_EQ(parse_streets(two_ways, "", "9").initial(), 2U);
  EXPECT_THROW(parse_streets(two_ways, "", "harbour"), ltl::FormatError);
  const auto long_way = [](const char* metres) {
    return parse_streets(R"({"nodes": [{"id": 1, "name": "A"}, {"id": 2, "name": "B"}],
      "edges": [{"a": 1, "b": 2, "metres": )" +
                         std::string(metres) + "}]}");
  };
  EXPECT_EQ(long_way("1e100").cost(0, 0), 1e100);
  EXPECT_THROW(long_way("1.01e100"), ltl::FormatError);
  EXPECT_THROW(long_way("-1"), ltl::FormatError);
  EXPECT_THROW(parse_streets(R"({"nodes": [{"id": 1, "name": "A"}, {"id": 2, "name": "a"}], "edges": []})"),
               ltl::FormatError);
  EXPECT_THROW(parse_streets(R"({"nodes": [{"id": 1, "name": "A"}], "edges": [{"a": 1, "b": 2, "metres": 1}]})"),
               ltl::FormatError);
}

TEST(Streets, OfTheCitiesCanBeWalked) {
  const auto folder = waymark::testing::shared() / "osm" / "maps";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no street maps at " << folder;
  std::size_t cities = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++cities;
    const PlanningCase city = read_model(entry.path());
    const Mdp& streets = std::get<Mdp>(city.model);
    for (const std::string& name : streets.letters().vocabulary().names()) {
      const CaseTask task{"", "F \"" + name + '"', CaseTask::Logic::Ltl, CaseTask::Query::MinCost};
      EXPECT_EQ(answer(city, task).status, CaseAnswer::Status::Solved) << city.name << ": " << name;
    }
  }
  EXPECT_GT(cities, 0U);
}

}  // namespace
}  // namespace waymark::plan
