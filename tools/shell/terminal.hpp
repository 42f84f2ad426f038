// The abilities of standard output and standard error: colour, Unicode, a progress bar, or lines of progress.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace waymark::tools {

enum class Paint { Bold, Dim, Red, Green, Blue };

struct Terminal {
  bool colour = false;   // a terminal, and neither NO_COLOR nor TERM=dumb says otherwise
  bool unicode = false;  // a terminal, and the locale is UTF-8
  std::string paint(Paint how, std::string_view text) const;
};
Terminal terminal_of(int file_descriptor);

// "error: message" (or another label) on standard error, once per problem.
void complain(std::string_view label, std::string_view message);

// The lines that say how far a long job is where nothing redraws itself, as in a pipe or a log: the first when `every`
// has passed since the first report, then one each time that it has passed again. A short job has none.
class ProgressLines {
 public:
  using Clock = std::chrono::steady_clock;
  explicit ProgressLines(Clock::duration every) : every_(every) {}
  std::string line(Clock::time_point now, double fraction, std::string_view what);  // whole, or empty: not yet

 private:
  Clock::duration every_;
  std::optional<Clock::time_point> last_;
};

// How far a long job is, on standard error: on a terminal one line that redraws itself, else whole lines.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  // wipes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(double fraction,
            std::string_view what);  // from one thread at a time; redraws at most 20 times a second
  void wipe();

 private:
  bool redraws_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_;
  ProgressLines lines_;
};

bool stdin_is_terminal();

std::string fixed(double value, int digits);   // "12.50"; the C locale, always
std::string hexadecimal(std::uint64_t value);  // 16 digits

}  // namespace waymark::tools
