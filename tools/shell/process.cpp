#include "tools/shell/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <system_error>

namespace waymark::tools {
namespace {

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "pipe");
  }
  ~Pipe() {
    close(0);
    close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close(std::size_t end) {
    if (ends.at(end) >= 0) ::close(ends.at(end));
    ends.at(end) = -1;
  }
};

enum class Signals { Shielded, Own };  // are SIGINT and SIGTERM kept from the child?

// The child ignores no signal that we ignore or block, but for those that it is shielded from.
pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, const Pipe& in,
            const Pipe& out, Signals signals) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  sigset_t blocked;
  sigemptyset(&blocked);
  if (signals == Signals::Shielded) {
    sigaddset(&blocked, SIGINT);
    sigaddset(&blocked, SIGTERM);
  }
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setsigmask(&attributes, &blocked);
  pid_t child = 0;
  const int error = ::posix_spawn(&child, program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(error, "cannot start " + program.string());
  return child;
}

// Of this thread: what is written to a helper that does not read is an error and no signal.
class WithoutBrokenPipe {
 public:
  WithoutBrokenPipe() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutBrokenPipe() {
    const timespec at_once{};
    while (sigtimedwait(&pipe_, nullptr, &at_once) == SIGPIPE) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutBrokenPipe(const WithoutBrokenPipe&) = delete;
  WithoutBrokenPipe& operator=(const WithoutBrokenPipe&) = delete;

 private:
  sigset_t pipe_{}, before_{};
};

std::mutex running_mutex;
std::vector<pid_t> running;

class Running {  // a child, among those that run
 public:
  explicit Running(pid_t child) : child_(child) {
    const std::lock_guard lock(running_mutex);
    running.push_back(child);
  }
  ~Running() {
    const std::lock_guard lock(running_mutex);
    running.erase(std::find(running.begin(), running.end(), child_));
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  pid_t child_;
};

// Both directions at once: neither side waits for the other with a full pipe.
std::string converse(Pipe& in, Pipe& out, std::string_view input, const std::stop_token& stop) {
  constexpr int milliseconds_between_looks = 20;
  std::string output;
  std::array<char, 1U << 16U> buffer{};
  if (input.empty()) in.close(1);
  while (true) {
    std::array<pollfd, 2> ends{{{out.ends[0], POLLIN, 0}, {in.ends[1], POLLOUT, 0}}};
    if (stop.stop_requested()) return output;
    const int wait = stop.stop_possible() ? milliseconds_between_looks : -1;
    if (::poll(ends.data(), in.ends[1] >= 0 ? 2 : 1, wait) < 0 && errno != EINTR) fail(errno, "poll");
    if (in.ends[1] >= 0 && ends[1].revents != 0) {
      const ssize_t written = ::write(in.ends[1], input.data(), std::min<std::size_t>(input.size(), 4096));
      if (written > 0) input.remove_prefix(static_cast<std::size_t>(written));
      if (written < 0 || input.empty()) in.close(1);  // EPIPE: it has read enough
    }
    if (ends[0].revents != 0) {
      const ssize_t got = ::read(out.ends[0], buffer.data(), buffer.size());
      if (got <= 0) return output;
      output.append(buffer.data(), static_cast<std::size_t>(got));
    }
  }
}

Finished run(const std::filesystem::path& program, const std::vector<std::string>& arguments, std::string_view input,
             const std::stop_token& stop, Signals signals) {
  Pipe in, out;
  const WithoutBrokenPipe quiet;
  const pid_t child = spawn(program, arguments, in, out, signals);
  const Running listed(child);
  in.close(0);
  out.close(1);
  Finished finished{.output = converse(in, out, input, stop)};
  in.close(1);
  const bool stopped = stop.stop_requested();
  if (stopped) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail(errno, "waitpid");
  if (stopped) throw HelperStopped{};
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return finished;
}

}  // namespace

void signal_helpers(int signal) {
  const std::lock_guard lock(running_mutex);
  for (const pid_t child : running) ::kill(child, signal);
}

Finished run_helper(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                    std::string_view input, const std::stop_token& stop) {
  return run(program, arguments, input, stop, Signals::Shielded);
}

Finished run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                     std::string_view input) {
  return run(program, arguments, input, {}, Signals::Own);
}

}  // namespace waymark::tools
