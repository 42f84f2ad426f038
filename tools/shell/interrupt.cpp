#include "tools/shell/interrupt.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "libparser/model/whole_file.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

constexpr int grace_milliseconds = 250;
constexpr char stop_byte = 's', done_byte = 'd';
volatile std::sig_atomic_t writer = -1;  // the handler's end of the pipe

void put(char byte) {
  const int saved = errno;
  [[maybe_unused]] const auto written = ::write(writer, &byte, 1);  // the pipe is never full: nobody writes much
  errno = saved;
}
extern "C" void on_signal(int) { put(stop_byte); }

}  // namespace

Interrupt::Interrupt() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  reader_ = ends[0];
  writer = ends[1];
  watcher_ = std::thread(&Interrupt::watch, this);
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  put(done_byte);
  watcher_.join();
  ::close(writer);
  ::close(reader_);
}

void Interrupt::watch() {
  char byte = 0;
  ssize_t got = 0;
  while ((got = ::read(reader_, &byte, 1)) < 0 && errno == EINTR) {
  }
  if (got != 1 || byte == done_byte) return;
  stop_.request_stop();
  pollfd pipe{reader_, POLLIN, 0};
  while (::poll(&pipe, 1, grace_milliseconds) > 0) {  // a second Ctrl-C starts the grace period anew
    if (::read(reader_, &byte, 1) == 1 && byte == done_byte) return;
  }
  signal_helpers(SIGKILL);
  parser::discard_unfinished_files();
  constexpr std::string_view message = "\nerror: interrupted\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(static_cast<int>(ExitCode::GaveUp));
}

}  // namespace waymark::tools
