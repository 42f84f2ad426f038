// The semantic choices of docs/conventions.md that this library answers for, one named test each.
#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/plan_of.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

class Conventions : public ::testing::Test {
 protected:
  // "FORWARD LEFT", "" for the plan that stays, "infeasible" for none.
  static std::string plan(const Map& map, const std::string& formula, const std::vector<PoseId>& starts) {
    ltl::Arena arena(map.vocabulary());
    const ltl::Formula f = ltl::parse(formula, arena, {.unknown = ltl::Unknown::Reject});
    const Planned planned = plan_of(map, f, starts);
    if (!std::holds_alternative<CertifiedRoute>(planned)) return "infeasible";
    std::string out;
    for (Action action : std::get<CertifiedRoute>(planned).route().actions)
      out += (out.empty() ? "" : " ") + std::string(name(action));
    return out;
  }
  static bool satisfies(const Map& map, const std::string& trajectory, const std::string& formula) {
    ltl::Arena arena(map.vocabulary());
    return ltl::holds(word_of(parse_trajectory(trajectory, map), map), ltl::parse(formula, arena));
  }
};

TEST_F(Conventions, LettersSitOnMoves) {
  const Map map = hallway(2);
  const ltl::Trace word = word_of(parse_trajectory("0,0,90 FORWARD LEFT", map), map);
  ASSERT_EQ(word.size(), 3U);
  EXPECT_EQ(word[0], map.label(pose_at(map, 0, 0, 90)));
  ltl::Letter moved = map.label(pose_at(map, 1, 0, 90)), turned = map.label(pose_at(map, 1, 0, 0));
  moved.insert(*map.vocabulary().find("moved"));
  turned.insert(*map.vocabulary().find("turned_left"));
  EXPECT_EQ(word[1], moved);
  EXPECT_EQ(word[2], turned);
  // An event belongs to the letter of its own action: nothing has happened at the start.
  EXPECT_TRUE(satisfies(map, "0,0,90", "!moved & !turned_left & !turned_right"));
  EXPECT_TRUE(satisfies(map, "0,0,90 FORWARD", "X (moved & corridor)"));
}

TEST_F(Conventions, StartLabelIsRead) {
  const Map map = hallway(2);
  const PoseId at_chair = pose_at(map, 2, 0, 90), away = pose_at(map, 0, 0, 90);
  EXPECT_EQ(plan(map, "chair", {at_chair}), "");
  EXPECT_EQ(plan(map, "chair", {away}), "infeasible");
  EXPECT_EQ(plan(map, "F chair", {at_chair}), "");
  EXPECT_EQ(plan(map, "!chair & F chair", {at_chair}), "infeasible");
  EXPECT_EQ(plan(map, "G !chair", {at_chair}), "infeasible");
}

TEST_F(Conventions, PlanStopsAtLeastCost) {
  const Map map = hallway(4);
  const PoseId start = pose_at(map, 0, 0, 90);
  EXPECT_EQ(plan(map, "F brick", {start}), "FORWARD");
  EXPECT_EQ(plan(map, "F chair", {start}), "FORWARD FORWARD FORWARD FORWARD");
  EXPECT_EQ(plan(map, "true", {start}), "");
  EXPECT_EQ(plan(map, "G blue", {start}), "");         // satisfied at once: nothing more is done
  EXPECT_EQ(plan(map, "X true", {start}), "FORWARD");  // one more letter, the first action there is
  EXPECT_EQ(plan(map, "G (chair -> X[w] false) & F moved", {start}), "FORWARD");
}

TEST_F(Conventions, TiesByActionOrder) {
  const Map map = plus();  // chair to the west of the crossing, sofa to the east
  const PoseId crossing = pose_at(map, 1, 1, 0), south = pose_at(map, 1, 1, 180);
  EXPECT_EQ(plan(map, "F (sofa | chair)", {crossing}), "LEFT FORWARD");  // RIGHT FORWARD costs as much
  EXPECT_EQ(plan(map, "F (sofa | chair)", {south}), "LEFT FORWARD");     // and so does RIGHT, to the other one
  EXPECT_EQ(plan(map, "F chair", {pose_at(map, 1, 1, 90)}), "LEFT LEFT FORWARD");  // RIGHT RIGHT, LEFT LEFT
  EXPECT_EQ(plan(map, "X X true", {crossing}), "FORWARD LEFT");                    // FORWARD FORWARD meets a wall
  EXPECT_EQ(plan(map, "X !moved", {crossing}), "LEFT");
  // The tie is between whole action strings: FORWARD comes as early as it can.
  const Map ring = square();
  EXPECT_EQ(plan(ring, "F moved & F turned_left & F turned_right", {pose_at(ring, 0, 0, 90)}), "FORWARD LEFT RIGHT");
}

TEST_F(Conventions, StartSetsGoByCostThenByOrder) {
  const Map map = hallway(3);
  std::vector<PoseId> starts;
  for (int heading : {0, 90, 180, 270}) starts.push_back(pose_at(map, 0, 0, heading));
  EXPECT_EQ(plan(map, "F chair", starts), "FORWARD FORWARD FORWARD");  // the pose that already faces east
  EXPECT_EQ(plan(map, "F ahead_open", {starts[0], starts[2]}), "RIGHT");
  EXPECT_EQ(plan(map, "F ahead_open", {starts[2], starts[0]}), "LEFT");
  EXPECT_EQ(plan(map, "chair", starts), "infeasible");
}

TEST_F(Conventions, StrongAndWeakNextDifferAtTheEnd) {
  const Map map = hallway(1);
  const PoseId start = pose_at(map, 0, 0, 90);
  EXPECT_EQ(plan(map, "X chair", {start}), "FORWARD");
  EXPECT_EQ(plan(map, "N chair", {start}), "");  // the word may end here
  EXPECT_EQ(plan(map, "X[w] chair & F moved", {start}), "FORWARD");
}

TEST_F(Conventions, ForwardKCountsMoves) {
  const Map map = hallway(4);
  const PoseId start = pose_at(map, 0, 0, 90), back = pose_at(map, 0, 0, 270);
  EXPECT_EQ(plan(map, "X(moved & X(moved & X moved))", {start}), "FORWARD FORWARD FORWARD");
  EXPECT_EQ(plan(map, "X moved", {back}), "infeasible");  // no turn is implied
}

TEST_F(Conventions, AdvanceMovesAtLeastOnceAndStraight) {
  const Map map = hallway(4);
  EXPECT_EQ(plan(map, "X(moved U (moved & chair))", {pose_at(map, 1, 0, 90)}), "FORWARD FORWARD FORWARD");
  EXPECT_EQ(plan(map, "X(moved U (moved & corridor))", {pose_at(map, 1, 0, 90)}), "FORWARD");
  EXPECT_EQ(plan(map, "X(moved U (moved & chair))", {pose_at(map, 4, 0, 90)}), "infeasible");
  EXPECT_EQ(plan(map, "X(moved U (moved & chair))", {pose_at(map, 1, 0, 0)}), "infeasible");
}

TEST_F(Conventions, FaceTurnsAtLeastOnceAndStays) {
  const Map map = hallway(2);
  const std::string face_open = "X((turned_left | turned_right) U ((turned_left | turned_right) & ahead_open))";
  EXPECT_EQ(plan(map, face_open, {pose_at(map, 0, 0, 0)}), "RIGHT");
  EXPECT_EQ(plan(map, face_open, {pose_at(map, 0, 0, 180)}), "LEFT");
  EXPECT_EQ(plan(map, face_open, {pose_at(map, 0, 0, 270)}), "LEFT LEFT");
  EXPECT_EQ(plan(map, face_open, {pose_at(map, 0, 0, 90)}),
            "LEFT RIGHT");  // already so: at least one turn all the same
}

TEST_F(Conventions, OrientAllowsAnyTurnsFirst) {
  const Map map = hallway(2);
  const std::string turned = "(turned_left | turned_right)", rest = "X moved";
  const std::string orient_then_move = rest + " | X(" + turned + " U (" + turned + " & " + rest + "))";
  EXPECT_EQ(plan(map, orient_then_move, {pose_at(map, 0, 0, 90)}),
            "FORWARD");  // no turn is needed, none is made
  EXPECT_EQ(plan(map, orient_then_move, {pose_at(map, 0, 0, 0)}), "RIGHT FORWARD");
  EXPECT_EQ(plan(map, orient_then_move, {pose_at(map, 0, 0, 270)}), "LEFT LEFT FORWARD");
}

TEST_F(Conventions, ThenIsPlannedAsAWhole) {
  // (0,0) start facing east: the nearer chair, one step west, is on the way to no lamp; the farther one is.
  const Map map("fork", {{0, 0, {}, {}}, {1, 0, {}, {}}, {2, 0, "chair", {}}, {3, 0, "lamp", {}}, {-1, 0, "chair", {}}},
                {{0, 1, "", ""}, {1, 2, "", ""}, {2, 3, "", ""}, {4, 0, "", ""}}, {"chair", "lamp"}, {}, {});
  const PoseId start = pose_at(map, 0, 0, 270);
  EXPECT_EQ(plan(map, "F chair", {start}), "FORWARD");
  // Greedy would fetch the near chair first and walk 1 + 2 + 4; the plan turns and takes the far one.
  EXPECT_EQ(plan(map, "F (chair & F lamp)", {start}), "LEFT LEFT FORWARD FORWARD FORWARD");
}

}  // namespace
}  // namespace waymark::plan
