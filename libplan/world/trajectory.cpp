#include "libplan/world/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstdlib>

#include "libplan/world/json_position.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

// "(9,9) is no place of grid; the nearest is (1,9)"
std::string no_such_pose(const Map& map, const Pose& pose) {
  if (map.hallways().node_at(pose.x, pose.y))
    return show(pose) + ": the heading must be 0, 90, 180 or 270, clockwise from north";
  const auto distance = [&](const Node& node) {
    return std::abs(std::int64_t{node.x} - pose.x) + std::abs(std::int64_t{node.y} - pose.y);
  };
  const Node& nearest = *std::min_element(map.nodes().begin(), map.nodes().end(),
                                          [&](const Node& a, const Node& b) { return distance(a) < distance(b); });
  const auto place = [](int x, int y) { return "(" + std::to_string(x) + "," + std::to_string(y) + ")"; };
  return place(pose.x, pose.y) + " is no place of " + (map.name().empty() ? "the map" : map.name()) +
         "; the nearest is " + place(nearest.x, nearest.y);
}

// "no single action leads from (1,9,0) to (1,7,0); FORWARD leads to (1,8,0), LEFT to …"
std::string impossible_step(const Map& map, PoseId from, PoseId to) {
  std::string out = "no single action leads from " + show(map.pose(from)) + " to " + show(map.pose(to)) + ";";
  const char* separator = " ";
  for (Action action : all_actions) {
    const auto next = map.successor(from, action);
    out += separator + std::string(name(action)) + (next ? " leads to " + show(map.pose(*next)) : " meets a wall");
    separator = ", ";
  }
  return out;
}

std::optional<int> parse_int(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// The numbers of "1,9,0"; nullopt when a piece is no whole number.
std::optional<std::vector<int>> parse_numbers(std::string_view text) {
  std::vector<int> numbers;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto number = parse_int(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == text.size()) return numbers;
    text.remove_prefix(comma + 1);
  }
}

class JsonForm {
 public:
  JsonForm(std::string_view text, const Map& map, std::string_view source) : in_(text, source), map_(map) {}

  Trajectory read() const {
    const Value document = in_.parse();
    std::string path;
    for (const char* key : {"route", "poses"})
      if (path.empty() && document.is_object() && document.contains(key)) path = key;
    const Value& list = path.empty() ? document : document[path];
    if (!list.is_array()) in_.fail(path, "expected a list of poses [x,y,heading]");
    if (list.empty()) in_.fail(path, "a trajectory needs at least one pose");
    Trajectory trajectory;
    for (std::size_t i = 0; i < list.size(); ++i) append(list[i], path + "[" + std::to_string(i) + "]", trajectory);
    return trajectory;
  }

 private:
  using Value = JsonReader::Value;

  void append(const Value& value, const std::string& path, Trajectory& trajectory) const {
    if (!value.is_array() || value.size() != 3) in_.fail(path, "expected a pose [x,y,heading]");
    std::array<int, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = in_.integer(value[i], path + "[" + std::to_string(i) + "]");
    const Pose pose{numbers[0], numbers[1], numbers[2]};
    const auto id = map_.find(pose);
    if (!id) in_.fail(path, no_such_pose(map_, pose));
    if (!trajectory.poses.empty()) {
      const auto action = action_between(map_, trajectory.poses.back(), *id);
      if (!action) in_.fail(path, impossible_step(map_, trajectory.poses.back(), *id));
      trajectory.actions.push_back(*action);
    }
    trajectory.poses.push_back(*id);
  }

  const JsonReader in_;
  const Map& map_;
};

struct Token {
  std::string_view text;
  std::size_t offset;
};

std::vector<Token> tokens(std::string_view text, std::string_view separators) {
  std::vector<Token> out;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else if (separators.find(text[at]) != std::string_view::npos) {
      ++at;
    } else {
      const std::size_t end = std::min(text.find_first_of(std::string(separators) + "#", at), text.size());
      out.push_back({text.substr(at, end - at), at});
      at = end;
    }
  }
  return out;
}

Trajectory parse_actions(std::string_view text, const Map& map, std::string_view source) {
  const std::vector<Token> pieces = tokens(text, " \t\r\n");
  const auto fail = [&](const Token& token, const std::string& message) {
    throw format_error_at(source, text, token.offset, message);
  };
  if (pieces.empty()) throw format_error_at(source, text, 0, "expected a start pose x,y,heading and actions");
  Trajectory trajectory;
  const auto numbers = parse_numbers(pieces[0].text);
  if (!numbers || numbers->size() != 3)
    fail(pieces[0], "expected a start pose x,y,heading, found '" + std::string(pieces[0].text) + "'");
  const Pose start{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  const auto id = map.find(start);
  if (!id) fail(pieces[0], no_such_pose(map, start));
  trajectory.poses.push_back(*id);
  const std::size_t begin = pieces[0].offset + pieces[0].text.size();
  for (Token token : tokens(text.substr(begin), " \t\r\n,")) {
    token.offset += begin;
    const auto action = parse_action(token.text);
    if (!action) fail(token, "expected FORWARD, LEFT or RIGHT, found '" + std::string(token.text) + "'");
    const auto next = map.successor(trajectory.poses.back(), *action);
    if (!next) fail(token, "FORWARD meets a wall at " + show(map.pose(trajectory.poses.back())));
    trajectory.actions.push_back(*action);
    trajectory.poses.push_back(*next);
  }
  return trajectory;
}

}  // namespace

std::optional<Action> action_between(const Map& map, PoseId from, PoseId to) {
  for (Action action : all_actions)
    if (map.successor(from, action) == to) return action;
  return std::nullopt;
}

std::optional<Trajectory> follow(const Map& map, PoseId start, const std::vector<Action>& actions) {
  Trajectory trajectory{{start}, {}};
  for (Action action : actions) {
    const auto next = map.successor(trajectory.poses.back(), action);
    if (!next) return std::nullopt;
    trajectory.poses.push_back(*next);
    trajectory.actions.push_back(action);
  }
  return trajectory;
}

ltl::Trace word_of(const Trajectory& trajectory, const Map& map) {
  assert(trajectory.poses.size() == trajectory.actions.size() + 1);
  std::vector<ltl::Letter> letters{map.label(trajectory.poses.front())};
  for (std::size_t i = 0; i < trajectory.actions.size(); ++i)
    letters.push_back(map.letter(trajectory.poses[i + 1], trajectory.actions[i]));
  return ltl::Trace(std::move(letters));
}

ltl::FormatError unknown_proposition(const Map& map, const std::string& name) {
  return unknown_proposition("the map " + map.name(), map.vocabulary(), name);
}

ltl::Trace word_for(ltl::Formula f, const Trajectory& trajectory, const Map& map) {
  const ltl::Vocabulary& names = f.arena().vocabulary();
  std::vector<std::pair<ltl::Proposition, ltl::Proposition>> matched;  // of the formula, of the map
  for (ltl::Proposition p : ltl::propositions(f)) {
    const auto ours = map.vocabulary().find(names.name(p));
    if (!ours) throw unknown_proposition(map, names.name(p));
    matched.emplace_back(p, *ours);
  }
  std::vector<ltl::Letter> letters;
  for (const ltl::Letter& letter : word_of(trajectory, map)) {
    ltl::Letter seen;
    for (const auto& [theirs, ours] : matched)
      if (letter.contains(ours)) seen.insert(theirs);
    letters.push_back(std::move(seen));
  }
  return ltl::Trace(std::move(letters));
}

Trajectory parse_trajectory(std::string_view text, const Map& map, std::string_view source) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_json = first != text.npos && (text[first] == '[' || text[first] == '{');
  return is_json ? JsonForm(text, map, source).read() : parse_actions(text, map, source);
}

std::vector<PoseId> parse_start(std::string_view text, const Map& map) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() < 2 || numbers->size() > 3)
    throw ltl::FormatError("", 0, 0, "expected a pose x,y,heading, found '" + std::string(text) + "'");
  Pose pose{(*numbers)[0], (*numbers)[1], numbers->size() == 3 ? (*numbers)[2] : -1};
  const bool unknown_heading = pose.heading == -1;
  std::vector<PoseId> starts;
  for (int heading = 0; heading < (unknown_heading ? 360 : 90); heading += 90) {
    if (unknown_heading) pose.heading = heading;
    const auto id = map.find(pose);
    if (!id) throw ltl::FormatError("", 0, 0, no_such_pose(map, pose));
    starts.push_back(*id);
  }
  return starts;
}

std::optional<Action> parse_action(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  for (Action action : all_actions)
    if (upper == name(action) || upper == name(action).substr(0, 1)) return action;
  return std::nullopt;
}

std::string show(const Trajectory& trajectory, const Map& map) {
  const Pose start = map.pose(trajectory.poses.front());
  std::string out = std::to_string(start.x) + "," + std::to_string(start.y) + "," + std::to_string(start.heading);
  for (Action action : trajectory.actions) out += " " + std::string(name(action));
  return out;
}

}  // namespace waymark::plan
