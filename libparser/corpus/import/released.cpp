#include "libparser/corpus/import/released.hpp"

#include <algorithm>
#include <charconv>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

class Scanner {  // of poses
 public:
  // column: of the first character; 0: not known.
  Scanner(std::string_view text, std::string_view file, std::size_t line, std::size_t column)
      : text_(text), file_(file), line_(line), column_(column) {}

  bool at_end() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' || text_[at_] == '\n'))
      ++at_;
    return at_ == text_.size();
  }
  bool take(char c) {
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(std::string("expected '") + c + "'");
  }
  // FORWARD, LEFT or RIGHT, with [I] where the sentence does not say so; empty: none stands here.
  std::string_view take_action() {
    for (const std::string_view action : {"FORWARD", "LEFT", "RIGHT"})
      if (!at_end() && text_.substr(at_, action.size()) == action) {
        at_ += action.size();
        if (text_.substr(at_, 3) == "[I]") at_ += 3;
        return action;
      }
    return {};
  }
  plan::Pose pose() {
    plan::Pose pose;
    expect('(');
    pose.x = number();
    expect(',');
    pose.y = number();
    expect(',');
    pose.heading = number();
    expect(')');
    if (pose.heading < -1 || pose.heading > 270 || (pose.heading != -1 && pose.heading % 90 != 0))
      fail("expected a heading: 0, 90, 180, 270, or -1 where it is left open");
    return pose;
  }
  [[noreturn]] void fail(const std::string& message) const {
    const std::string_view before = text_.substr(0, at_);
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t column = lines > 0 ? at_ - before.rfind('\n') : column_ > 0 ? column_ + at_ : 0;
    throw ltl::FormatError(file_, line_ + lines, column, message);
  }

 private:
  int number() {
    if (at_end()) fail("expected a number");
    int value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    constexpr int limit = plan::Hallways::max_coordinate;
    if (error == std::errc::result_out_of_range || value < -limit || value > limit)
      fail("expected a whole number between −1,000,000 and 1,000,000");
    if (error != std::errc()) fail("expected a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  std::string_view text_, file_;
  std::size_t line_, column_, at_ = 0;
};

}  // namespace

std::vector<plan::Pose> parse_pose_list(std::string_view text, std::string_view file, std::size_t line) {
  Scanner in(text, file, line, 0);
  std::vector<plan::Pose> poses;
  in.expect('[');
  do poses.push_back(in.pose());
  while (in.take(','));
  in.expect(']');
  if (!in.at_end()) in.fail("expected the end of the trajectory");
  return poses;
}

ReleasedTrace parse_trace(std::string_view text, std::string_view file, std::size_t line, std::size_t column) {
  Scanner in(text, file, line, column);
  ReleasedTrace trace;
  std::vector<std::string_view> actions;
  for (std::string_view action = in.take_action(); !action.empty(); action = in.take_action()) {
    actions.push_back(action);
    trace.poses.push_back(in.pose());
    in.expect(';');
  }
  trace.poses.push_back(in.pose());
  if (!in.at_end()) in.fail("expected the end of the trace after the pose without an action");
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const std::string_view shown = action_between(trace.poses[i], trace.poses[i + 1]);
    if (!shown.empty() && shown != actions[i]) trace.mislabelled.push_back(i);
  }
  return trace;
}

std::string_view action_between(const plan::Pose& a, const plan::Pose& b) {
  const int dx = b.x - a.x, dy = b.y - a.y;
  if (dx == 0 && dy == 0) {
    const int turn = (b.heading - a.heading + 360) % 360;
    return turn == 90 ? "RIGHT" : turn == 270 ? "LEFT" : "";
  }
  if (a.heading != b.heading) return "";
  const bool ahead = a.heading == 0     ? dx == 0 && dy == -1
                     : a.heading == 90  ? dx == 1 && dy == 0
                     : a.heading == 180 ? dx == 0 && dy == 1
                                        : a.heading == 270 && dx == -1 && dy == 0;
  return ahead ? "FORWARD" : "";
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace waymark::parser
