// The abilities of standard output and standard error: colour, Unicode, a progress bar.
#pragma once
#include <chrono>
#include <cstdint>
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

// One line on standard error that redraws itself; silent when that is no terminal.
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
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_;
};

bool stdin_is_terminal();

std::string fixed(double value, int digits);   // "12.50"; the C locale, always
std::string hexadecimal(std::uint64_t value);  // 16 digits

}  // namespace waymark::tools
