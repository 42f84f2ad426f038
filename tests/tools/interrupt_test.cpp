// Ctrl-C ends long work within half a second, with exit code 11 and one message.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/sanitizers.hpp"

namespace {

using Clock = std::chrono::steady_clock;

struct Ended {
  int exit_code = -1;
  double seconds = 0;  // from the signal to the end
  std::string messages;
};

// Is there a handler by now? How long a process takes to get there is nobody's promise.
bool catches(pid_t process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  const std::string key = "SigCgt:";
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, key.size(), key) == 0)
      return (std::stoull(line.substr(key.size()), nullptr, 16) >> (signal - 1) & 1U) != 0;
  return false;
}

// Starts waymark, sends the signal when it has been at work for a while, waits for the end. `temporary`: the folder of
// its temporary files; empty: that of everybody.
Ended interrupt(const std::vector<std::string>& arguments, int signal, const std::string& temporary = "") {
  std::string name = (std::filesystem::temp_directory_path() / "waymark-interrupt-XXXXXX").string();
  const int messages = ::mkstemp(name.data());
  const pid_t child = ::fork();
  if (child == 0) {
    std::vector<char*> argv{const_cast<char*>(WAYMARK_EXECUTABLE)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::dup2(messages, STDERR_FILENO);
    if (!temporary.empty()) ::setenv("TMPDIR", temporary.c_str(), 1);
    ::execv(WAYMARK_EXECUTABLE, argv.data());
    ::_exit(127);
  }
  const auto started = Clock::now();
  while (!catches(child, signal) && Clock::now() - started < std::chrono::seconds(60))
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto sent = Clock::now();
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  Ended ended{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
              .seconds = std::chrono::duration<double>(Clock::now() - sent).count(),
              .messages = ""};
  ::close(messages);
  std::ifstream file(name);
  ended.messages.assign(std::istreambuf_iterator<char>(file), {});
  std::filesystem::remove(name);
  return ended;
}

constexpr double soon = waymark::testing::sanitized ? 10 : 3;  // seconds, on a busy machine; robust.interrupts measures

// Its minimal DFA remembers which of 24 propositions held in the last step but one, and so on: hours of work.
std::string hard_formula() {
  std::string text;
  for (int i = 0; i < 24; ++i) {
    const std::string p = "p" + std::to_string(i), q = "q" + std::to_string(i);
    text += (i > 0 ? " & " : "") + std::string("F(") + p + " & X X X " + q + " & F(" + q + " & G(" + p + " -> X X " +
            q + ")))";
  }
  return text;
}

TEST(CtrlC, EndsATranslationSoon) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Ended ended = interrupt({"translate", "--to", "dfa", "--max-states", "4000000000", hard_formula()}, signal);
    EXPECT_EQ(ended.exit_code, 11) << ended.messages;
    EXPECT_LT(ended.seconds, soon);
    EXPECT_NE(ended.messages.find("error: interrupted"), std::string::npos) << ended.messages;
  }
}

TEST(CtrlC, EndsAWaitForInput) {
  if (waymark::testing::signals_wait) GTEST_SKIP() << "the thread sanitizer keeps the signal";
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const int saved = ::dup(STDIN_FILENO);
  ::dup2(ends[0], STDIN_FILENO);  // nobody ever writes
  const Ended ended = interrupt({"translate", "-F", "-"}, SIGINT);
  ::dup2(saved, STDIN_FILENO);
  for (const int end : {ends[0], ends[1], saved}) ::close(end);
  EXPECT_EQ(ended.exit_code, 11) << ended.messages;
  EXPECT_LT(ended.seconds, soon);
}

// The actions of the map slip, so values are asked for by the solvers of models.
TEST(CtrlC, OfAPlanWithSlipsSaysThatItWasInterrupted) {
  const std::string task =
      "F(chair & X X X sofa & F(sofa & G(chair -> X X sofa))) & F(sofa & X X X easel & F(easel & G(sofa -> X X easel)))"
      " & F(easel & X X X lamp & F(lamp & G(easel -> X X lamp))) & F(lamp & X X X hatrack & F(hatrack & G(lamp -> X X "
      "hatrack))) & F(hatrack & X X X barstool & F(barstool & G(hatrack -> X X barstool)))";
  const Ended ended = interrupt({"plan", task, "--map", "grid", "--start", "1,9,0", "--slip", "0.1,0.1"}, SIGTERM);
  EXPECT_EQ(ended.exit_code, 11) << ended.messages;
  EXPECT_LT(ended.seconds, soon);
  EXPECT_NE(ended.messages.find("error: interrupted"), std::string::npos) << ended.messages;
}

TEST(CtrlC, OfARecordedExperimentLeavesNoFolder) {
  const std::filesystem::path place = std::filesystem::path(::testing::TempDir()) / "waymark-interrupted-experiment";
  std::filesystem::remove_all(place);
  for (const int signal : {SIGINT, SIGTERM}) {
    std::filesystem::create_directory(place);
    const Ended ended = interrupt({"experiment", "known-language", "--check"}, signal, place);
    EXPECT_EQ(ended.exit_code, 11) << ended.messages;
    EXPECT_LT(ended.seconds, soon);
    EXPECT_TRUE(std::filesystem::is_empty(place));
    std::filesystem::remove_all(place);
  }
}

}  // namespace
