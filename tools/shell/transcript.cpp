#include "tools/shell/transcript.hpp"

#include <algorithm>
#include <charconv>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

constexpr std::string_view command_mark = "$ waymark ", exit_mark = "[exit ", measured = "MEASURED";

class TranscriptReader {
 public:
  TranscriptReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  std::vector<TranscriptStep> read() {
    bool slow = false;
    while (const auto line = next()) {
      if (line->starts_with('#') || line->empty()) {
        slow = slow || *line == "# slow";
      } else if (line->starts_with(command_mark)) {
        steps_.push_back(step(line->substr(command_mark.size()), slow));
      } else {
        fail("expected '$ waymark …' or a comment");
      }
    }
    return std::move(steps_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw ltl::FormatError(std::string(source_), number_, 1, what);
  }
  std::optional<std::string_view> next() {
    if (text_.empty()) return std::nullopt;
    const std::size_t end = text_.find('\n');
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    ++number_;
    return line;
  }
  TranscriptStep step(std::string_view command, bool slow) {
    TranscriptStep out;
    out.line = number_;
    out.arguments = words(command);
    out.slow = slow;
    if (out.arguments.size() > 1 && *(out.arguments.end() - 2) == ">") {
      out.output = out.arguments.back();
      out.arguments.resize(out.arguments.size() - 2);
    }
    while (const auto line = next()) {
      if (!line->starts_with(exit_mark)) {
        out.printed.emplace_back(*line);
        continue;
      }
      const std::string_view code = line->substr(exit_mark.size());
      if (std::from_chars(code.data(), code.data() + code.size(), out.exit_code).ec != std::errc())
        fail("expected [exit N]");
      return out;
    }
    fail("expected [exit N] before the end");
  }
  // Words between blanks; what stands between ' and ' is one word, or a part of one.
  std::vector<std::string> words(std::string_view text) const {
    std::vector<std::string> out;
    bool quoted = false, inside = false;
    for (const char c : text) {
      const bool blank = c == ' ' && !quoted;
      if (!blank && !inside) out.emplace_back();
      inside = !blank;
      if (c == '\'')
        quoted = !quoted;
      else if (!blank)
        out.back() += c;
    }
    if (quoted) fail("expected ' before the end of the line");
    return out;
  }

  std::string_view text_, source_;
  std::size_t number_ = 0;
  std::vector<TranscriptStep> steps_;
};

std::string with_single_blanks(std::string_view text) {  // columns are as wide as their numbers
  std::string out;
  for (const char c : text)
    if (c != ' ' || out.empty() || out.back() != ' ') out += c;
  return out;
}

}  // namespace

std::vector<TranscriptStep> parse_transcript(std::string_view text, std::string_view source) {
  return TranscriptReader(text, source).read();
}

bool agrees(std::string_view recorded, std::string_view line) {
  const std::string said = with_single_blanks(recorded), got = with_single_blanks(line);
  std::string_view printed = said, now = got;
  for (std::size_t at; (at = printed.find(measured)) != std::string_view::npos;) {
    const bool braced = at > 0 && printed[at - 1] == '{';
    if (now.substr(0, at) != printed.substr(0, at)) return false;
    const std::size_t end = braced ? now.find('}', at) : now.find_first_not_of("0123456789.e+-", at);
    if (end == at) return false;
    printed.remove_prefix(at + measured.size());
    now.remove_prefix(std::min(end, now.size()));
  }
  return printed == now;
}

}  // namespace waymark::tools
