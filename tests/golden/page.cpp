#include "tests/golden/page.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <sstream>

#include "tests/golden/replay.hpp"

namespace waymark::golden {
namespace {

namespace fs = std::filesystem;

// The page with the answer to each command replaced by what `answer` gives for that command.
std::string with_answers(const std::string& page, const std::function<std::string(const std::string&)>& answer) {
  std::istringstream in(page);
  std::string out;
  std::string command;
  bool inside = false;
  bool reads_command = false;
  const auto finish = [&] {
    if (reads_command) out += answer(command);
    reads_command = false;
  };
  for (std::string line; std::getline(in, line);) {
    if (inside && line.starts_with("$ ")) {
      finish();
      command = line.substr(2);
      reads_command = true;
      out += line + '\n';
    } else if (reads_command && (line == ">" || line.starts_with("> "))) {
      command += '\n' + (line == ">" ? "" : line.substr(2));
      out += line + '\n';
    } else if (line == "```console" || (inside && line == "```")) {
      finish();
      inside = !inside;
      out += line + '\n';
    } else if (!inside) {
      out += line + '\n';
    } else {
      finish();  // what was printed last time is left out
    }
  }
  return out;
}

}  // namespace

std::string rerun_page(const std::string& page, const fs::path& folder) {
  return with_answers(page, [&](const std::string& command) { return run(command, folder).output; });
}

std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> commands;
  with_answers(page, [&](const std::string& command) {
    commands.push_back(command);
    return std::string();
  });
  return commands;
}

void expect_page_is_true(const fs::path& page) {
  const std::string expected = read(page);
  ASSERT_FALSE(commands_of(expected).empty()) << page << " shows no command";
  const fs::path scratch =
      fs::path(::testing::TempDir()) / ("waymark-" + page.stem().string() + "-" + std::to_string(::getpid()));
  fs::create_directories(scratch);
  compare(page, expected, rerun_page(expected, scratch));
  fs::remove_all(scratch);
}

}  // namespace waymark::golden
