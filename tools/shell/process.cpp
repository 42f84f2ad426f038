#include "tools/shell/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
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

pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, const Pipe& in,
            const Pipe& out) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  pid_t child = 0;
  const int error = ::posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(error, "cannot start " + program.string());
  return child;
}

// Both directions at once: neither side waits for the other with a full pipe.
std::string converse(Pipe& in, Pipe& out, std::string_view input) {
  std::string output;
  std::array<char, 1U << 16U> buffer{};
  if (input.empty()) in.close(1);
  while (true) {
    std::array<pollfd, 2> ends{{{out.ends[0], POLLIN, 0}, {in.ends[1], POLLOUT, 0}}};
    if (::poll(ends.data(), in.ends[1] >= 0 ? 2 : 1, -1) < 0 && errno != EINTR) fail(errno, "poll");
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

std::atomic<pid_t> running = 0;

}  // namespace

void signal_helper(int signal) {
  if (const pid_t child = running; child > 0) ::kill(child, signal);
}

Finished run_helper(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                    std::string_view input) {
  Pipe in, out;
  std::signal(SIGPIPE, SIG_IGN);
  const pid_t child = spawn(program, arguments, in, out);
  running = child;
  in.close(0);
  out.close(1);
  Finished finished{.output = converse(in, out, input)};
  in.close(1);
  std::signal(SIGPIPE, SIG_DFL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail(errno, "waitpid");
  running = 0;
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return finished;
}

}  // namespace waymark::tools
