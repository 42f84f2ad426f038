// Pages of the manual whose commands are run, each in an empty folder of its own: the tutorial, one page for each task,
// and the tables for users of other tools. The pages of docs/first-five-minutes run against the installed waymark.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <system_error>

#include "tests/golden/page.hpp"
#include "tests/golden/replay.hpp"

namespace waymark::golden {
namespace {

namespace fs = std::filesystem;

const fs::path manual = fs::path(WAYMARK_SOURCE_DIR) / "docs";

std::vector<fs::path> pages() {
  std::vector<fs::path> found{manual / "tutorial.md", manual / "coming-from.md"};
  std::error_code missing;  // a copy of the tree without the manual
  for (const auto& entry : fs::directory_iterator(manual / "tasks", missing)) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

class Pages : public ::testing::TestWithParam<fs::path> {};

TEST_P(Pages, ShowWhatTheirCommandsPrint) { expect_page_is_true(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Manual, Pages, ::testing::ValuesIn(pages()), [](const auto& page) {
  std::string name = page.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
});

// The second column of the tables for users of other tools has our commands. They run in order, in one folder, after
// the commands of the blocks, which write the files. A command answers yes (0) or no (10).
TEST(ComingFrom, HasCommandsThatRun) {
  const std::string page = read(manual / "coming-from.md");
  const fs::path scratch = fs::path(::testing::TempDir()) / ("waymark-coming-from-" + std::to_string(::getpid()));
  fs::create_directories(scratch);
  rerun_page(page, scratch);
  const std::regex row(R"(^\| [^|]* \| `(waymark [^`]*)` \|.*)");
  const std::regex escaped_bar(R"(\\\|)");
  std::istringstream in(page);
  std::size_t commands = 0;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    ++commands;
    const CommandResult result = run(std::regex_replace(match.str(1), escaped_bar, "|"), scratch);
    EXPECT_TRUE(result.exit == 0 || result.exit == 10) << match.str(1) << "\n" << result.output;
    EXPECT_FALSE(result.output.empty() && line.find(" --out ") == std::string::npos) << match.str(1);
  }
  EXPECT_GE(commands, 40U) << "the tables of coming-from.md are not recognised";
  fs::remove_all(scratch);
}

TEST(Page, ContinuesCommandsAndForgetsOldAnswers) {
  const std::string page = "prose\n```console\n$ echo a \\\n> b\nold\nolder\n$ true\n```\n$ prose\n> prose\n";
  EXPECT_EQ(commands_of(page), (std::vector<std::string>{"echo a \\\nb", "true"}));
  EXPECT_EQ(rerun_page(page, ::testing::TempDir()),
            "prose\n```console\n$ echo a \\\n> b\na b\n$ true\n```\n$ prose\n> prose\n");
}

}  // namespace
}  // namespace waymark::golden
