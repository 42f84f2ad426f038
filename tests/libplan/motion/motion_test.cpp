#include "libplan/motion/motion.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <type_traits>

#include "libltl/text/parse.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

static_assert(!std::is_constructible_v<CertifiedMotion, Motion, CertifiedRoute>, "only certify makes one");

// From centre to centre, turning in place: what a route looks like without a body.
Motion along_centres(const Trajectory& route, const Map& map, double radius) {
  Motion motion{{}, Disc{radius}};
  for (PoseId id : route.poses) {
    const Pose pose = map.pose(id);
    motion.configurations.push_back({1.0 * pose.x, 1.0 * pose.y, 1.0 * pose.heading});
  }
  return motion;
}

std::string route_text(const Motion& motion, const Workspace& workspace) {
  const auto read = route_of(motion, workspace);
  if (const auto* fault = std::get_if<NoRoute>(&read)) return std::to_string(fault->step) + ": " + fault->reason;
  return show(std::get<Trajectory>(read), workspace.map());
}

TEST(TurnBetween, TakesTheShortWay) {
  const struct {
    double from, to, turn;
  } table[] = {{0, 90, 90},    {90, 0, -90},  {0, 270, -90}, {270, 0, 90}, {350, 10, 20},
               {10, 350, -20}, {0, 180, 180}, {180, 0, 180}, {45, 45, 0}};
  for (const auto& row : table) EXPECT_DOUBLE_EQ(turn_between(row.from, row.to), row.turn) << row.from << row.to;
}

TEST(Motion, ReadsTheRouteOffTheGeometry) {
  const Map map = square();  // (0,0) (1,0) (1,1) (0,1); no furniture in this workspace
  const Workspace workspace(map, {.width = 0.4, .furniture = 0});
  const struct {
    const char* what;
    std::vector<Configuration> line;
    const char* route;
  } table[] = {
      {"standing", {{0, 0, 90}}, "0,0,90"},
      {"one step", {{0, 0, 90}, {1, 0, 90}}, "0,0,90 FORWARD"},
      {"just into the next cell", {{0, 0, 90}, {0.81, 0.1, 90}}, "0,0,90 FORWARD"},
      {"out and back is no event", {{0, 0, 90}, {0.7, 0, 90}, {0, 0.1, 90}}, "0,0,90"},
      {"out, back, and on", {{0, 0, 90}, {0.5, 0, 90}, {0, 0, 90}, {1, 0, 90}}, "0,0,90 FORWARD"},
      {"a turn in three parts", {{0, 0, 0}, {0, 0, 30}, {0, 0, 60}, {0, 0, 90}}, "0,0,0 RIGHT"},
      {"looking aside is no turn", {{0, 0, 0}, {0, 0, 40}, {0, 0, 0}}, "0,0,0"},
      {"turning left past north", {{0, 0, 0}, {0, 0, 270}}, "0,0,0 LEFT"},
      {"nearly half a turn is two", {{0, 0, 0}, {0, 0, 179}}, "0,0,0 RIGHT RIGHT"},
      {"turning while moving inside the cell", {{0, 0, 180}, {0.1, 0.1, 90}, {1, 0.1, 90}}, "0,0,180 LEFT FORWARD"},
      {"round the corner", {{0, 0, 90}, {1, 0, 90}, {1, 0, 180}, {1, 1, 180}}, "0,0,90 FORWARD RIGHT FORWARD"},
  };
  for (const auto& row : table) EXPECT_EQ(route_text({row.line, Disc{0.05}}, workspace), row.route) << row.what;
}

TEST(Motion, NamesWhatIsNoRoute) {
  const Map map = square();
  const Workspace workspace(map, {.width = 0.4, .furniture = 0.07});  // a sofa at (1,1)
  const struct {
    std::vector<Configuration> line;
    const char* fault;
  } table[] = {
      {{}, "0: a motion needs at least one configuration"},
      {{{0, 0, 360}}, "0: not a configuration: headings run from 0 to below 360"},
      {{{0.5, 0, 90}}, "0: the motion does not start at a place"},
      {{{0.5, 0.5, 90}}, "0: the motion does not start at a place"},
      {{{0.18, 0.18, 90}}, "0: the robot does not fit where it starts"},
      {{{1, 1, 90}}, "0: the robot does not fit where it starts"},
      {{{0, 0, 90}, {0.5, 0, 90}}, "1: the motion does not end at a place"},
      {{{0, 0, 90}, {1, -0.17, 90}}, "1: the robot touches a wall or furniture"},
      {{{0, 0, 90}, {0.1, 0, 90}, {1, 1, 90}}, "2: the robot touches a wall or furniture"},
      {{{0, 0, 180}, {1, 0, 180}}, "1: the robot enters a place that is not ahead of it"},
      {{{0, 0, 270}, {1, 0, 270}}, "1: the robot enters a place that is not ahead of it"},
      {{{0, 0, 90}, {1, 0, 90}, {0, 0, 90}}, "2: the robot enters a place that is not ahead of it"},
      {{{0, 0, 90}, {0.5, 0, 90}, {0.5, 0, 180}}, "2: the robot turns between two places"},
      {{{0, 0, 90}, {1, 0, 180}}, "1: the robot turns between two places"},
      {{{0, 0, 0}, {0, 0, 180}}, "1: half a turn at once: left or right?"},
  };
  for (const auto& row : table) EXPECT_EQ(route_text({row.line, Disc{0.05}}, workspace), row.fault);
}

void for_each_route(const Map& map, std::size_t most_actions, const std::function<void(const Trajectory&)>& use) {
  const std::function<void(const Trajectory&)> extend = [&](const Trajectory& route) {
    use(route);
    if (route.actions.size() == most_actions) return;
    for (Action action : all_actions)
      if (const auto next = map.successor(route.poses.back(), action)) {
        Trajectory longer = route;
        longer.poses.push_back(*next);
        longer.actions.push_back(action);
        extend(longer);
      }
  };
  for (std::uint32_t p = 0; p < map.poses(); ++p) extend(Trajectory{{PoseId{p}}, {}});
}

TEST(Motion, EveryRouteReadsBack) {
  std::size_t routes = 0;
  for (const Map& map : {plus(), square(), hallway(2)}) {
    const Workspace workspace(map, {.width = 0.4, .furniture = 0});
    for_each_route(map, 6, [&](const Trajectory& route) {
      ++routes;
      const auto read = route_of(along_centres(route, map, 0.1), workspace);
      ASSERT_TRUE(std::holds_alternative<Trajectory>(read)) << map.name() << " " << show(route, map);
      EXPECT_EQ(std::get<Trajectory>(read), route) << map.name() << " " << show(route, map);
    });
  }
  EXPECT_GT(routes, 10'000U);
}

TEST(Motion, LengthIsThatOfTheLine) {
  EXPECT_DOUBLE_EQ(length({{{0, 0, 0}, {3, 4, 0}, {3, 4, 90}, {4, 4, 90}}, Disc{0}}), 6);
  EXPECT_DOUBLE_EQ(length({{{0, 0, 0}}, Disc{0}}), 0);
}

TEST(CertifiedMotion, IsOneWhoseWordSatisfiesTheFormula) {
  const Map map = square();
  const Workspace workspace(map, {.width = 0.4, .furniture = 0});
  const Motion motion{{{0, 0, 90}, {1, 0, 90}, {1, 0, 180}, {1, 1, 180}}, Disc{0.05}};
  ltl::Arena arena(map.vocabulary());
  const auto phi = ltl::parse("place_1 & X(moved & X(turned_right & X(sofa & moved)))", arena);
  const CertifiedMotion certified = certify(motion, workspace, phi);
  EXPECT_EQ(certified.motion(), motion);
  EXPECT_EQ(show(certified.route().route(), map), "0,0,90 FORWARD RIGHT FORWARD");
  EXPECT_DOUBLE_EQ(certified.route().route().cost, 3);
}

TEST(CertifiedMotion, RefusesWhatDoesNotSatisfyTheFormulaOrIsNoRoute) {
  const Map map = square();
  const Workspace workspace(map);
  ltl::Arena arena(map.vocabulary());
  const Motion stays{{{0, 0, 90}}, Disc{0.05}}, sideways{{{0, 0, 0}, {1, 0, 0}}, Disc{0.05}};
  EXPECT_NO_THROW(certify(stays, workspace, ltl::parse("place_1", arena)));
  EXPECT_THROW(certify(stays, workspace, ltl::parse("F sofa", arena)), std::logic_error);
  EXPECT_THROW(certify(sideways, workspace, ltl::parse("true", arena)), std::logic_error);
}

}  // namespace
}  // namespace waymark::plan
