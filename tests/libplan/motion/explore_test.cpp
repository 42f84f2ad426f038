#include "libplan/motion/explore.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

// Certified when there is a motion.
Explored explored(const std::string& formula, const Workspace& workspace, PoseId start, const Robot& robot) {
  ltl::Arena arena(workspace.map().vocabulary());
  const ltl::Formula phi = ltl::parse(formula, arena);
  Explored outcome = explore(automata::ltlf_to_dfa(phi), workspace, start, {.seconds = 20, .robot = robot});
  const auto* motion = std::get_if<Motion>(&outcome);
  if (motion != nullptr) certify(*motion, workspace, phi);
  return outcome;
}

void for_each_route(const Map& map, std::size_t most_actions, Trajectory so_far,
                    const std::function<void(const Trajectory&)>& use) {
  use(so_far);
  if (so_far.actions.size() == most_actions) return;
  for (const Action action : all_actions)
    if (const auto next = map.successor(so_far.poses.back(), action)) {
      Trajectory longer = so_far;
      longer.poses.push_back(*next);
      longer.actions.push_back(action);
      for_each_route(map, most_actions, std::move(longer), use);
    }
}

// The state after reading the symbol for a few steps; nullopt: the run ends. At most one guard may hold.
std::optional<std::uint32_t> read(const SymbolAutomaton& task, std::uint32_t state, std::uint32_t symbol) {
  for (int step = 0; step < 3; ++step) {
    const auto& row = task.transitions[state];
    const auto holds = [&](const SymbolAutomaton::Transition& t) { return t.symbol == symbol; };
    EXPECT_LE(std::count_if(row.begin(), row.end(), holds), 1);
    const auto found = std::find_if(row.begin(), row.end(), holds);
    if (found == row.end()) return std::nullopt;
    state = found->target;
  }
  return state;
}

// Route by route, each symbol read for several steps: what OMPL is told agrees with the automaton, X and events
// included.
TEST(Explore, SymbolsSayWhatTheWordSays) {
  const Map map = square();
  const Workspace workspace(map);
  std::size_t accepted = 0;
  for (const char* formula : {"F sofa", "X moved", "X X X turned_left", "F(sofa & X(turned_right & X moved))",
                              "G !sofa", "place_1 & X !place_1", "moved U turned_left", "N N false"}) {
    ltl::Arena arena(map.vocabulary());
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(formula, arena));
    for (const PoseId start : {pose_at(map, 0, 0, 90), pose_at(map, 1, 1, 0)}) {
      const SymbolAutomaton task = task_over_symbols(dfa, workspace, start);
      for_each_route(map, 5, Trajectory{{start}, {}}, [&](const Trajectory& route) {
        std::optional<std::uint32_t> state = task.start;
        for (std::size_t i = 0; i < route.actions.size() && state; ++i) {
          const PoseId from = route.poses[i], to = route.poses[i + 1];
          if (route.actions[i] == Action::Forward) {
            const Edge* hallway = map.hallway(map.node_of(from), map.pose(from).heading);
            const auto edge = static_cast<std::uint32_t>(hallway - map.edges().data());
            const auto nodes = static_cast<std::uint32_t>(map.nodes().size());
            state = read(task, *state, 4 * (nodes + edge) + from.index % 4);
          }
          if (state) state = read(task, *state, to.index);
        }
        const bool says = state && task.accepting[*state];
        EXPECT_EQ(says, automata::accepts(dfa, word_of(route, map))) << formula << " on " << show(route, map);
        if (says) ++accepted;
      });
    }
  }
  EXPECT_GT(accepted, 300U);
}

TEST(Explore, FindsMotionsOfDiscsAndCars) {
  const Map map = square();
  const Workspace workspace(map);
  for (const Robot& robot : {Robot(Disc{}), Robot(Disc{0}), Robot(Car{})})
    for (const char* formula : {"F sofa", "X(moved & X(turned_right & X(sofa & moved)))", "F(sofa & F place_1)"})
      EXPECT_TRUE(std::holds_alternative<Motion>(explored(formula, workspace, pose_at(map, 0, 0, 90), robot)))
          << formula << " " << robot.index();
}

TEST(Explore, StartsWithEveryHeading) {
  const Map map = square();
  const Workspace workspace(map);
  for (const int heading : {0, 90, 180, 270})
    EXPECT_TRUE(std::holds_alternative<Motion>(explored("F sofa", workspace, pose_at(map, 0, 0, heading), Disc{})))
        << heading;
}

TEST(Explore, AnUnsolvableTaskIsNoRunAndNoCrash) {
  const Map map = square();
  const Workspace workspace(map);
  for (const char* formula : {"F chair", "F sofa & G !sofa", "X(moved & X(moved))", "!place_1", "false"})
    EXPECT_TRUE(std::holds_alternative<NoRun>(explored(formula, workspace, pose_at(map, 0, 0, 90), Disc{}))) << formula;
}

TEST(Explore, ReadsTheLetterOfTheStart) {
  const Map map = square();
  const Workspace workspace(map);
  const auto outcome = explored("place_1", workspace, pose_at(map, 0, 0, 90), Disc{});
  ASSERT_TRUE(std::holds_alternative<Motion>(outcome));
  EXPECT_EQ(std::get<Motion>(outcome).configurations.size(), 1U);
}

}  // namespace
}  // namespace waymark::plan
