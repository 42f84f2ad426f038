// One of PRISM's explicit files, read line by line and word by word. Errors name line and column.
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"

namespace waymark::plan {

class ExplicitLines {
 public:
  ExplicitLines(std::istream& in, const std::string& source) : reader_(in, source), source_(source) {}

  bool next() {  // the next line that is neither blank nor a comment
    while (reader_.next(text_)) {
      at_ = 0;
      bytes_ += text_.size() + 1;
      if (bytes_ > most_explicit_bytes) fail("expected at most " + std::to_string(most_explicit_bytes >> 30U) + " GiB");
      if (!at_end() && text_[at_] != '#') return true;
    }
    text_.clear();
    at_ = 0;
    return false;
  }
  bool at_end() {  // of the line
    skip_blanks();
    return at_ == text_.size();
  }
  std::string_view word() {  // up to a blank
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    if (begin == at_) fail("expected more on this line");
    return std::string_view(text_).substr(begin, at_ - begin);
  }
  std::uint32_t index() {  // a whole number from 0 on
    skip_blanks();
    std::uint32_t out = 0;
    const auto [rest, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), out);
    if (error != std::errc()) fail("expected a whole number from 0 on");
    at_ = static_cast<std::size_t>(rest - text_.data());
    return out;
  }
  std::uint32_t index_below(std::size_t bound, const char* what) {  // the same, below a bound; `what` is told in errors
    skip_blanks();
    const std::size_t begin = at_;
    const std::uint32_t out = index();
    if (out >= bound) {
      at_ = begin;
      fail(std::string("there is no ") + what + ' ' + std::to_string(out));
    }
    return out;
  }
  double number() {  // finite
    skip_blanks();
    const std::size_t begin = at_;
    double out = 0;
    const auto [rest, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), out);
    at_ = static_cast<std::size_t>(rest - text_.data());
    if (error == std::errc() && std::isfinite(out) && (at_ == text_.size() || is_blank(text_[at_]))) return out;
    at_ = begin;
    fail("expected a number");
  }
  void expect(char c) {  // next, past blanks
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) fail(std::string("expected '") + c + '\'');
    ++at_;
  }
  std::string_view until(char c) {  // up to the character, which is passed over
    const std::size_t begin = at_;
    at_ = text_.find(c, at_);
    if (at_ == std::string::npos) {
      at_ = begin;
      fail(std::string("expected '") + c + "' later on this line");
    }
    return std::string_view(text_).substr(begin, at_++ - begin);
  }
  void expect_end() {  // of the line
    if (!at_end()) fail("expected the end of the line");
  }
  [[noreturn]] void fail(const std::string& message) const {  // throws ltl::FormatError at the place that is read
    throw ltl::FormatError(source_, std::max<std::size_t>(reader_.number(), 1),
                           ltl::utf8_length(std::string_view(text_).substr(0, at_)) + 1, message);
  }

 private:
  static constexpr std::size_t most_explicit_bytes = std::size_t{64} << 30U;  // of one file
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  ltl::LineReader reader_;
  std::string source_, text_;
  std::size_t at_ = 0, bytes_ = 0;
};

}  // namespace waymark::plan
