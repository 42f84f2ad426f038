#include "tools/shell/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iostream>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool utf8_locale() {  // POSIX: the first of these that is set decides
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const auto value = environment(name);
    if (value.empty()) continue;
    return value.find("UTF-8") != std::string_view::npos || value.find("utf8") != std::string_view::npos;
  }
  return false;
}

std::string_view code(Paint how) {
  switch (how) {
    case Paint::Bold: return "\x1b[1m";
    case Paint::Dim: return "\x1b[2m";
    case Paint::Red: return "\x1b[1;31m";
    case Paint::Green: return "\x1b[32m";
    case Paint::Blue: return "\x1b[34m";
  }
  return "";
}

}  // namespace

std::string Terminal::paint(Paint how, std::string_view text) const {
  if (!colour) return std::string(text);
  return std::string(code(how)).append(text).append("\x1b[0m");
}

Terminal terminal_of(int file_descriptor) {
  if (::isatty(file_descriptor) == 0) return {};
  return {.colour = environment("NO_COLOR").empty() && environment("TERM") != "dumb", .unicode = utf8_locale()};
}

void complain(std::string_view label, std::string_view message) {
  std::cout.flush();
  std::cerr << terminal_of(STDERR_FILENO).paint(Paint::Red, std::string(label) + ":") << ' ' << ltl::printable(message)
            << '\n';
}

std::string ProgressLines::line(Clock::time_point now, double fraction, std::string_view what) {
  if (!last_) last_ = now;
  if (now - *last_ < every_) return {};
  last_ = now;
  return std::string(what) + ": " + fixed(100 * fraction, 0) + " %\n";
}

ProgressBar::ProgressBar()
    : redraws_(::isatty(STDERR_FILENO) != 0 && environment("TERM") != "dumb"), lines_(std::chrono::seconds(30)) {}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::wipe() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

void ProgressBar::show(double fraction, std::string_view what) {
  const auto now = std::chrono::steady_clock::now();
  if (!redraws_) {
    std::cerr << lines_.line(now, fraction, what) << std::flush;
    return;
  }
  if (drawn_ && now - last_ < std::chrono::milliseconds(50)) return;
  last_ = now;
  drawn_ = true;
  constexpr int width = 30;
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
  std::cerr << "\r\x1b[K[" << std::string(static_cast<std::size_t>(full), '#')
            << std::string(static_cast<std::size_t>(width - full), ' ') << "] " << fixed(100 * fraction, 0) << " %  "
            << what << std::flush;
}

bool stdin_is_terminal() { return ::isatty(STDIN_FILENO) != 0; }

std::string hexadecimal(std::uint64_t value) {
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, value >>= 4U)
    *digit = "0123456789abcdef"[value & 15U];
  return digits;
}

std::string fixed(double value, int digits) {
  std::array<char, 400> buffer{};  // the longest double has 309 digits before the point
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits).ptr;
  return {buffer.data(), end};
}

}  // namespace waymark::tools
