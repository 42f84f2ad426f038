// Pages whose ```console blocks are run: every command, in order, in one empty folder. A line that starts with `$ ` is
// a command; the lines up to the next one, or to the end of the block, are what it prints.
#include <gtest/gtest.h>
#include <unistd.h>

#include <sstream>

#include "tests/golden/replay.hpp"

namespace waymark::golden {
namespace {

namespace fs = std::filesystem;

// The page as it would be written now: the same prose and commands, fresh answers.
std::string rerun(const std::string& page, const fs::path& folder) {
  std::istringstream in(page);
  std::string out;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "```console" || (inside && line == "```")) {
      inside = !inside;
      out += line + '\n';
    } else if (inside && line.starts_with("$ ")) {
      out += line + '\n' + run(line.substr(2), folder).output;
    } else if (!inside) {
      out += line + '\n';
    }
  }
  return out;
}

TEST(Tutorial, ShowsWhatItsCommandsPrint) {
  const fs::path page = fs::path(WAYMARK_SOURCE_DIR) / "docs/tutorial.md";
  const fs::path scratch = fs::path(testing::TempDir()) / ("waymark-tutorial-" + std::to_string(::getpid()));
  fs::create_directories(scratch);
  const std::string expected = read(page);
  ASSERT_NE(expected.find("```console\n$ "), std::string::npos) << page << " shows no command";
  compare(page, expected, rerun(expected, scratch));
  fs::remove_all(scratch);
}

}  // namespace
}  // namespace waymark::golden
