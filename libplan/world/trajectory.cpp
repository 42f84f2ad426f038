#include "libplan/world/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstdlib>

#include "libltl/text/foreign.hpp"
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

std::string not_closed(const Map& map, PoseId begin) {
  return "the cycle must lead back to " + show(map.pose(begin)) + ", where it begins, by one action or more";
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

  Walk read() const {
    const Value document = in_.parse();
    Walk walk;
    if (document.is_object() && document.contains("cycle") && !document.contains("route")) {
      append_all(document, "prefix", walk.trajectory);
      const std::size_t prefix = walk.trajectory.actions.size();
      const PoseId begin = walk.trajectory.poses.back();
      append_all(document, "cycle", walk.trajectory);
      walk.repeated = walk.trajectory.actions.size() - prefix;
      if (walk.repeated == 0 || walk.trajectory.poses.back() != begin) in_.fail("cycle", not_closed(map_, begin));
      return walk;
    }
    if (document.is_object() && document.contains("cycle") && !document["cycle"].is_array())
      in_.fail("cycle", "expected a list of poses [x,y,heading]");
    std::string path;
    for (const char* key : {"route", "poses", "steps"})
      if (path.empty() && document.is_object() && document.contains(key)) path = key;
    append_all(document, path, walk.trajectory);
    return walk;
  }

 private:
  using Value = JsonReader::Value;

  // The list under this key, or the document itself; the first pose of a list that goes on is the last one so far.
  void append_all(const Value& document, const std::string& path, Trajectory& trajectory) const {
    static const Value absent;
    const Value& list = path.empty() ? document : document.contains(path) ? document[path] : absent;
    if (!list.is_array()) in_.fail(path, "expected a list of poses [x,y,heading]");
    if (list.empty()) in_.fail(path, "a trajectory needs at least one pose");
    const bool goes_on = !trajectory.poses.empty();
    const PoseId last = goes_on ? trajectory.poses.back() : PoseId{};
    for (std::size_t i = 0; i < list.size(); ++i) {
      const bool step = list[i].is_object() && list[i].contains("pose");  // of waymark check --progress
      const Value& pose = step ? list[i]["pose"] : list[i];
      const std::string place = path + "[" + std::to_string(i) + (step ? "].pose" : "]");
      if (i > 0 || !goes_on) {
        append(pose, place, trajectory);
      } else if (pose_of(pose, place) != last) {
        in_.fail(place, "expected " + show(map_.pose(last)) + ", where the prefix ends");
      }
    }
  }

  PoseId pose_of(const Value& value, const std::string& path) const {
    if (!value.is_array() || value.size() != 3) in_.fail(path, "expected a pose [x,y,heading]");
    std::array<int, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = in_.integer(value[i], path + "[" + std::to_string(i) + "]");
    const Pose pose{numbers[0], numbers[1], numbers[2]};
    const auto id = map_.find(pose);
    if (!id) in_.fail(path, no_such_pose(map_, pose));
    return *id;
  }

  void append(const Value& value, const std::string& path, Trajectory& trajectory) const {
    const PoseId id = pose_of(value, path);
    if (!trajectory.poses.empty()) {
      const auto action = action_between(map_, trajectory.poses.back(), id);
      if (!action) in_.fail(path, impossible_step(map_, trajectory.poses.back(), id));
      trajectory.actions.push_back(*action);
    }
    trajectory.poses.push_back(id);
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

// "(", ")w" and their likes stand apart from the actions, or touch them.
std::vector<Token> with_brackets_apart(const std::vector<Token>& pieces) {
  std::vector<Token> out;
  for (const Token& piece : pieces) {
    for (std::size_t at = 0; at < piece.text.size();) {
      const bool opens = piece.text[at] == '(', closes = piece.text[at] == ')';
      const std::size_t end = opens    ? at + 1
                              : closes ? piece.text.size()
                                       : std::min(piece.text.find_first_of("()", at), piece.text.size());
      out.push_back({piece.text.substr(at, end - at), piece.offset + at});
      at = end;
    }
  }
  return out;
}

class TextForm {
 public:
  TextForm(std::string_view text, const Map& map, std::string_view source) : text_(text), map_(map), source_(source) {}

  Walk read() {
    if (const std::string hint = ltl::foreign_hint(text_); !hint.empty())
      throw format_error_at(source_, text_, 0, "expected a start pose x,y,heading and actions: " + hint);
    const std::vector<Token> pieces = tokens(text_, " \t\r\n");
    if (pieces.empty()) throw format_error_at(source_, text_, 0, "expected a start pose x,y,heading and actions");
    read_start(pieces[0]);
    const std::size_t begin = pieces[0].offset + pieces[0].text.size();
    for (Token& token : with_brackets_apart(tokens(text_.substr(begin), " \t\r\n,"))) {
      token.offset += begin;
      if (walk_.repeated > 0) fail(token, "nothing follows what is repeated for ever");
      if (token.text == "(") {
        if (cycle_) fail(token, "a walk has one cycle");
        cycle_ = walk_.trajectory.actions.size();
      } else if (token.text.starts_with(')')) {
        close(token);
      } else {
        read_action(token);
      }
    }
    if (cycle_ && walk_.repeated == 0) throw format_error_at(source_, text_, text_.size(), "expected ')w'");
    return std::move(walk_);
  }

 private:
  [[noreturn]] void fail(const Token& token, const std::string& message) const {
    throw format_error_at(source_, text_, token.offset, message);
  }

  void read_start(const Token& piece) {
    const auto numbers = parse_numbers(piece.text);
    if (!numbers || numbers->size() != 3)
      fail(piece, "expected a start pose x,y,heading, found '" + std::string(piece.text) + "'");
    const Pose start{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    const auto id = map_.find(start);
    if (!id) fail(piece, no_such_pose(map_, start));
    walk_.trajectory.poses.push_back(*id);
  }

  void read_action(const Token& token) {
    Trajectory& trajectory = walk_.trajectory;
    const auto action = parse_action(token.text);
    if (!action) fail(token, "expected FORWARD, LEFT or RIGHT, found '" + std::string(token.text) + "'");
    const auto next = map_.successor(trajectory.poses.back(), *action);
    if (!next) fail(token, "FORWARD meets a wall at " + show(map_.pose(trajectory.poses.back())));
    trajectory.actions.push_back(*action);
    trajectory.poses.push_back(*next);
  }

  void close(const Token& token) {
    if (!cycle_) fail(token, "')' without '('");
    if (token.text != ")w" && token.text != ")^w" && token.text != ")ʷ") fail(token, "expected ')w'");
    const PoseId begin = walk_.trajectory.poses[*cycle_];
    walk_.repeated = walk_.trajectory.actions.size() - *cycle_;
    if (walk_.repeated == 0 || walk_.trajectory.poses.back() != begin) fail(token, not_closed(map_, begin));
  }

  std::string_view text_;
  const Map& map_;
  std::string_view source_;
  Walk walk_;
  std::optional<std::size_t> cycle_;  // actions before it
};

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

ltl::Lasso lasso_of(const Walk& walk, const Map& map) {
  const ltl::Trace word = word_of(walk.trajectory, map);
  const auto cycle = word.end() - static_cast<std::ptrdiff_t>(walk.repeated);
  return {{word.begin(), cycle}, {cycle, word.end()}};
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

Walk parse_walk(std::string_view text, const Map& map, std::string_view source) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_json = first != text.npos && (text[first] == '[' || text[first] == '{');
  return is_json ? JsonForm(text, map, source).read() : TextForm(text, map, source).read();
}

Trajectory parse_trajectory(std::string_view text, const Map& map, std::string_view source) {
  return parse_walk(text, map, source).trajectory;
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
