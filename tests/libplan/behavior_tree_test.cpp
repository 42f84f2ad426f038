#include "libplan/behavior_tree.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

Trajectory two_steps(const Map& map) {
  return *follow(map, pose_at(map, 0, 0, 90), {Action::Forward, Action::Left, Action::Right});
}

TEST(BehaviorTree, IsThisText) {
  const Map map = hallway(2);
  EXPECT_EQ(write_behavior_tree(*follow(map, pose_at(map, 0, 0, 90), {Action::Forward}), map, "F (a & \"b<c\")"),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<root BTCPP_format=\"4\" main_tree_to_execute=\"Plan\">\n"
            "  <BehaviorTree ID=\"Plan\">\n"
            "    <Sequence name=\"F (a &amp; &quot;b&lt;c&quot;)\">\n"
            "      <Action ID=\"Forward\" name=\"1\" from=\"(0,0,90)\" to=\"(1,0,90)\"/>\n"
            "    </Sequence>\n"
            "  </BehaviorTree>\n"
            "  <TreeNodesModel>\n"
            "    <Action ID=\"Forward\">\n"
            "      <input_port name=\"from\"/>\n"
            "      <input_port name=\"to\"/>\n"
            "    </Action>\n"
            "  </TreeNodesModel>\n"
            "</root>\n");
}

TEST(BehaviorTree, HasTheActionsOfThePlanInOrder) {
  const Map map = hallway(2);
  const Trajectory plan = two_steps(map);
  const std::string text = write_behavior_tree(plan, map, "task", 2);
  const std::regex action("<Action ID=\"(\\w+)\" name=\"\\d+\" from=\"([^\"]*)\" to=\"([^\"]*)\"/>");
  std::vector<Action> read;
  for (std::sregex_iterator at(text.begin(), text.end(), action), end; at != end; ++at) {
    EXPECT_EQ((*at)[2], show(map.pose(plan.poses[read.size()])));
    EXPECT_EQ((*at)[3], show(map.pose(plan.poses[read.size() + 1])));
    read.push_back(*parse_action((*at)[1].str()));
  }
  EXPECT_EQ(read, plan.actions);
  // The two last actions stand under Repeat.
  const auto repeat = text.find("<Repeat num_cycles=\"-1\">");
  EXPECT_LT(text.find("name=\"1\""), repeat);
  EXPECT_GT(text.find("name=\"2\""), repeat);
  EXPECT_LT(text.find("name=\"3\""), text.find("</Repeat>"));
}

// BehaviorTree.CPP refuses a sequence without children.
TEST(BehaviorTree, OfNoActionSucceedsAtOnce) {
  const Map map = hallway(1);
  const std::string text = write_behavior_tree({{pose_at(map, 0, 0, 90)}, {}}, map, "true");
  EXPECT_NE(text.find("<AlwaysSuccess/>"), std::string::npos);
}

}  // namespace
}  // namespace waymark::plan
