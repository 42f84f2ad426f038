// Batches on several threads: order, bad texts, time limits, exceptions.
#include "tools/shell/parallel.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

struct Outcome {
  ExitCode code;
  std::string output, problems;
};

Outcome run(std::vector<std::string> texts, const ParallelOptions& options, const Replier& answer) {
  TextReader reader({.arguments = std::move(texts), .file = ""}, "text");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const ExitCode code = answer_in_parallel(
      reader, {}, options, answer, [](const Text& text, const std::string&) { return "bad " + text.text + "\n"; });
  std::string output = testing::internal::GetCapturedStdout();
  return {code, std::move(output), testing::internal::GetCapturedStderr()};
}

std::vector<std::string> numbers(int count) {
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i) out.push_back(std::to_string(i));
  return out;
}

TEST(Parallel, RepliesComeInTheOrderOfTheTexts) {
  std::string expected;
  for (const std::string& number : numbers(2'000)) expected += number + '\n';
  for (const std::size_t threads : {1U, 2U, 7U}) {
    const Outcome result = run(numbers(2'000), {.threads = threads}, [](const Text& text, const TextWatch&) {
      if (std::stoi(text.text) % 100 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      return Reply{ExitCode::Done, text.text + '\n'};
    });
    EXPECT_EQ(result.output, expected) << threads;
    EXPECT_EQ(result.code, ExitCode::Done);
  }
}

TEST(Parallel, ABadTextEndsNothingButItself) {
  const Outcome result = run(numbers(4), {.threads = 2}, [](const Text& text, const TextWatch&) -> Reply {
    if (text.text == "1") throw ltl::FormatError("somewhere", 1, 2, "is wrong");
    if (text.text == "2") return {ExitCode::No, "no\n", "a problem"};
    return {ExitCode::Done, "yes\n"};
  });
  EXPECT_EQ(result.output, "yes\nbad 1\nno\nyes\n");
  EXPECT_EQ(result.code, ExitCode::BadInput);
  EXPECT_NE(result.problems.find("is wrong"), std::string::npos);
  EXPECT_NE(result.problems.find("a problem"), std::string::npos);
}

TEST(Parallel, EveryTextHasItsOwnTime) {
  const Outcome result =
      run(numbers(6), {.threads = 2, .limits = {.seconds = 0.05}}, [](const Text& text, const TextWatch& watch) {
        if (std::stoi(text.text) % 2 == 0) return Reply{ExitCode::Done, "soon\n"};
        while (!watch.token().stop_requested()) std::this_thread::yield();
        return Reply{ExitCode::GaveUp, watch.overrun() == ltl::Overrun::Time ? "late\n" : "stopped\n"};
      });
  EXPECT_EQ(result.output, "soon\nlate\nsoon\nlate\nsoon\nlate\n");
  EXPECT_EQ(result.code, ExitCode::GaveUp);
}

// Text 0 holds 96 MiB until it is stopped; the others want nothing.
TEST(Parallel, TheTextThatHoldsTooMuchGivesUpAlone) {
  const std::size_t most = (ltl::memory_held() >> 20U) + 64;
  const Outcome result =
      run(numbers(6), {.threads = 2, .limits = {.mebibytes = most}}, [](const Text& text, const TextWatch& watch) {
        if (text.text != "0") return Reply{ExitCode::Done, "small\n"};
        const std::vector<char> held(std::size_t{96} << 20U, 'x');
        while (!watch.token().stop_requested()) std::this_thread::yield();
        return Reply{ExitCode::GaveUp, watch.overrun() == ltl::Overrun::Memory ? "large\n" : "stopped\n"};
      });
  EXPECT_EQ(result.output, "large\nsmall\nsmall\nsmall\nsmall\nsmall\n");
}

TEST(Parallel, WhatIsNoBadTextEndsEverything) {
  TextReader reader({.arguments = numbers(50), .file = ""}, "text");
  const auto bug = [](const Text& text, const TextWatch&) -> Reply {
    if (text.text == "20") throw std::logic_error("a bug");
    return {};
  };
  EXPECT_THROW(answer_in_parallel(reader, {}, {.threads = 3}, bug, {}), std::logic_error);
  std::stop_source stop;
  stop.request_stop();
  TextReader more({.arguments = numbers(3), .file = ""}, "text");
  const auto fine = [](const Text&, const TextWatch&) { return Reply{}; };
  EXPECT_THROW(answer_in_parallel(more, stop.get_token(), {}, fine, {}), Interrupted);
}

TEST(Parallel, JobsAreAnsweredInTheirOrder) {
  const auto answer = [](std::size_t job, const TextWatch& watch) -> Reply {
    if (job == 3)  // until its time is over
      while (!watch.token().stop_requested()) std::this_thread::yield();
    return {job == 3 ? ExitCode::GaveUp : ExitCode::Done, std::to_string(job) + '\n',
            job == 5 ? "five is odd" : std::string()};
  };
  for (const std::size_t threads : {0U, 1U, 2U, 9U}) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const ExitCode code = answer_in_parallel(7, {}, {.threads = threads, .limits = {.seconds = 0.05}}, answer);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "0\n1\n2\n3\n4\n5\n6\n") << threads;
    EXPECT_NE(testing::internal::GetCapturedStderr().find("five is odd"), std::string::npos) << threads;
    EXPECT_EQ(code, ExitCode::GaveUp) << threads;
  }
  EXPECT_EQ(answer_in_parallel(0, {}, {}, answer), ExitCode::Done);
  const auto bad = [](std::size_t, const TextWatch&) -> Reply {
    throw ltl::FormatError("somewhere", 1, 2, "is wrong");
  };
  EXPECT_THROW(answer_in_parallel(3, {}, {.threads = 2}, bad), ltl::FormatError);
}

// Reading flushes what std::cin is tied to: a line that another thread had half written came out twice.
TEST(Parallel, WhoReadsStandardInputLeavesStandardOutputAlone) {
  std::ostream* before = std::cin.tie(&std::cout);
  const TextReader reader({.arguments = {"-"}, .file = ""}, "text");
  EXPECT_EQ(std::cin.tie(), nullptr);
  std::cin.tie(before);
}

}  // namespace
}  // namespace waymark::tools
