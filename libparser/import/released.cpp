#include "libparser/import/released.hpp"

#include <charconv>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

class Scanner {  // of one line of poses
 public:
  Scanner(std::string_view text, std::string_view file, std::size_t line)
      : text_(text), file_(file), line_(line) {}

  bool at_end() {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' || text_[at_] == '\n'))
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
  bool take_action() {  // FORWARD, LEFT or RIGHT, with [I] where the sentence does not say so
    for (const std::string_view action : {"FORWARD", "LEFT", "RIGHT"})
      if (!at_end() && text_.substr(at_, action.size()) == action) {
        at_ += action.size();
        if (text_.substr(at_, 3) == "[I]") at_ += 3;
        return true;
      }
    return false;
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
    throw ltl::FormatError(file_, line_, at_ + 1, message);
  }

 private:
  int number() {
    if (at_end()) fail("expected a number");
    int value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("expected a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  std::string_view text_, file_;
  std::size_t line_, at_ = 0;
};

}  // namespace

std::vector<plan::Pose> parse_pose_list(std::string_view text, std::string_view file, std::size_t line) {
  Scanner in(text, file, line);
  std::vector<plan::Pose> poses;
  in.expect('[');
  do poses.push_back(in.pose());
  while (in.take(','));
  in.expect(']');
  if (!in.at_end()) in.fail("expected the end of the trajectory");
  return poses;
}

std::vector<plan::Pose> parse_trace(std::string_view text, std::string_view file, std::size_t line) {
  Scanner in(text, file, line);
  std::vector<plan::Pose> poses;
  while (in.take_action()) {
    poses.push_back(in.pose());
    in.expect(';');
  }
  poses.push_back(in.pose());
  if (!in.at_end()) in.fail("expected the end of the trace after the pose without an action");
  return poses;
}

}  // namespace waymark::parser
