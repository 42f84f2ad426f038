#include "tools/farm/child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "tools/shell/seat.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t most_complained = 4096;             // bytes
constexpr std::size_t most_read = std::size_t{1} << 20U;  // at a time, and of a giver's output that waits

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

struct Ends {
  int read = -1, write = -1;
};

Ends make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
  return {ends[0], ends[1]};
}

// In the child, between fork and exec: nothing that takes a lock.
[[noreturn]] void become(char* const* argv, char* const* environment, pid_t parent, std::array<int, 5> ends,
                         bool keeps_input) {
  const auto [in, out, shown, complained, nothing] = ends;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  for (const int pipe : {in, out})
    if (pipe >= 0) ::fcntl(pipe, F_SETFD, 0);
  if (!keeps_input) ::dup2(nothing, STDIN_FILENO);
  ::dup2(shown >= 0 ? shown : nothing, STDOUT_FILENO);
  if (complained >= 0) ::dup2(complained, STDERR_FILENO);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM}) ::signal(number, SIG_DFL);
  ::execve(argv[0], argv, environment);
  ::_exit(127);
}

}  // namespace

OpenPipe::OpenPipe(int end) : end_(end) { ::fcntl(end, F_SETFL, ::fcntl(end, F_GETFL) | O_NONBLOCK); }

OpenPipe::~OpenPipe() {
  if (end_ >= 0) ::close(end_);
}

OpenPipe::OpenPipe(OpenPipe&& other) noexcept
    : end_(std::exchange(other.end_, -1)), unwritten_(std::move(other.unwritten_)), done_(other.done_) {}

OpenPipe& OpenPipe::operator=(OpenPipe&& other) noexcept {
  std::swap(end_, other.end_);
  std::swap(unwritten_, other.unwritten_);
  std::swap(done_, other.done_);
  return *this;
}

std::string OpenPipe::read() const {
  std::string all;
  std::array<char, 1U << 16U> buffer{};
  while (end_ >= 0 && all.size() < most_read) {
    const ssize_t got = ::read(end_, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    all.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return all;
}

void OpenPipe::write(std::string bytes) {
  unwritten_.push_back(std::move(bytes));
  flush();
}

void OpenPipe::flush() {
  while (end_ >= 0 && !unwritten_.empty()) {
    const std::string& first = unwritten_.front();
    const ssize_t written = ::write(end_, first.data() + done_, first.size() - done_);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) break;  // no room, or nobody reads: then the process has ended, which is noticed elsewhere
    done_ += static_cast<std::size_t>(written);
    if (done_ < first.size()) continue;
    unwritten_.pop_front();
    done_ = 0;
  }
}

Child::Child(const std::string& program, const std::vector<std::string>& arguments, ChildRole role) : role_(role) {
  Ends in, out;
  const bool speaks = role != ChildRole::Alone;
  std::string seat = "together";
  if (speaks) {
    in = make_pipe();
    out = make_pipe();
    seat = (role == ChildRole::Giver ? "giver " : "hand ") + std::to_string(in.read) + ' ' + std::to_string(out.write);
  }
  Ends shown, complained;
  if (role != ChildRole::Hand) shown = make_pipe();
  if (role != ChildRole::Giver) complained = make_pipe();
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0) fail("/dev/null");
  ::setenv(seat_variable, seat.c_str(), 1);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) fail("cannot start " + program);
  if (process_ == 0)
    become(argv.data(), environ, parent, {in.read, out.write, shown.write, complained.write, nothing},
           role == ChildRole::Giver);
  for (const int end : {in.read, out.write, shown.write, complained.write, nothing})
    if (end >= 0) ::close(end);
  if (speaks) to_ = OpenPipe(in.write);
  if (speaks) from_ = OpenPipe(out.read);
  if (shown.read >= 0) out_ = OpenPipe(shown.read);
  if (complained.read >= 0) err_ = OpenPipe(complained.read);
}

Child::~Child() {
  if (ended_) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Child::say(std::string_view frame) { to_.write(framed(frame)); }

std::optional<std::string> Child::hear() { return frames_.next(); }

void Child::look() {
  to_.flush();
  frames_.add(from_.read());
  if (role_ != ChildRole::Giver || shown_.size() < most_read) shown_ += out_.read();
  complained_ += err_.read();
  if (complained_.size() > most_complained) complained_.erase(0, complained_.size() - most_complained);
}

std::optional<Ending> Child::ending() {
  if (ended_) return ended_;
  int status = 0;
  if (::waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  for (bool more = true; more;) {  // what it said at last
    const std::string said = from_.read(), shown = out_.read();
    frames_.add(said);
    shown_ += shown;
    more = !said.empty() || !shown.empty();
  }
  look();
  const int killed = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  ended_ = Ending{killed != 0 ? 128 + killed : WEXITSTATUS(status), killed};
  return ended_;
}

void Child::signal(int number) const {
  if (!ended_) ::kill(process_, number);
}

void Child::add_to(std::vector<pollfd>& pipes) const {
  for (const OpenPipe* pipe : {&from_, &out_, &err_})
    if (pipe->end() >= 0) pipes.push_back({pipe->end(), POLLIN, 0});
  if (to_.has_unwritten()) pipes.push_back({to_.end(), POLLOUT, 0});
}

}  // namespace waymark::tools
