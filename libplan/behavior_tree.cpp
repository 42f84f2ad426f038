#include "libplan/behavior_tree.hpp"

#include <set>

namespace waymark::plan {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\n')
      out += "&#10;";
    else
      out += c;
  }
  return out;
}

std::string_view node_of(Action action) {
  switch (action) {
    case Action::Forward: return "Forward";
    case Action::Left: return "Left";
    case Action::Right: return "Right";
  }
  return "";  // unreachable: -Werror=switch
}

}  // namespace

std::string write_behavior_tree(const Trajectory& plan, const Map& map, std::string_view task,
                                std::size_t repeated_actions) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root BTCPP_format=\"4\" main_tree_to_execute=\"Plan\">\n"
      "  <BehaviorTree ID=\"Plan\">\n    <Sequence name=\"" +
      escaped(task) + "\">\n";
  const std::size_t actions = plan.actions.size(), cycle = actions - repeated_actions;
  std::string indent(6, ' ');
  std::set<std::string_view> used;
  for (std::size_t i = 0; i < actions; ++i) {
    if (i == cycle) {
      out += indent + "<Repeat num_cycles=\"-1\">\n" + indent + "  <Sequence>\n";
      indent += "    ";
    }
    const std::string_view node = node_of(plan.actions[i]);
    used.insert(node);
    out += indent + "<Action ID=\"" + std::string(node) + "\" name=\"" + std::to_string(i + 1) + "\" from=\"" +
           show(map.pose(plan.poses[i])) + "\" to=\"" + show(map.pose(plan.poses[i + 1])) + "\"/>\n";
  }
  if (repeated_actions > 0) out += "        </Sequence>\n      </Repeat>\n";
  if (actions == 0) out += "      <AlwaysSuccess/>\n";
  out += "    </Sequence>\n  </BehaviorTree>\n  <TreeNodesModel>\n";
  for (std::string_view node : used)
    out += "    <Action ID=\"" + std::string(node) +
           "\">\n      <input_port name=\"from\"/>\n      <input_port name=\"to\"/>\n    </Action>\n";
  return out + "  </TreeNodesModel>\n</root>\n";
}

}  // namespace waymark::plan
