// The pages of help: how they are set, and that every one fits a screen; the pages of the manual in the terminal.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/help_page.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

std::string said(const std::vector<std::string>& arguments) {
  return run_helper(WAYMARK_EXECUTABLE, arguments, "").output;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out.push_back(line);
  return out;
}

std::vector<std::string> subcommands() {
  std::vector<std::string> out;
  bool below = false;
  for (const std::string& line : split(said({"--help"}))) {
    if (below && line.starts_with("  ") && line[2] != ' ') out.push_back(line.substr(2, line.find(' ', 2) - 2));
    below = below || line == "Subcommands:";
  }
  return out;
}

void expect_narrow(const std::string& page, const std::string& name) {
  for (const std::string& line : split(page)) EXPECT_LE(ltl::utf8_length(line), help_columns) << name << ": " << line;
}

TEST(Help, OfEverySubcommandFitsAScreen) {
  const auto names = subcommands();
  ASSERT_GE(names.size(), 25U);
  for (const std::string& name : names) {
    if (name == "serve" && helper("waymark-serve").empty()) continue;
    const std::string page = said({name, "--help"});
    EXPECT_LE(split(page).size(), help_lines) << page;
    expect_narrow(page, name);
    const auto lines = split(page);
    ASSERT_GE(lines.size(), 3U) << name;
    EXPECT_TRUE(lines.back().starts_with("  waymark ")) << name << ": " << lines.back();
    EXPECT_EQ(lines[lines.size() - 3], "Examples:") << name;
    expect_narrow(said({name, "--help-all"}), name + " --help-all");
  }
  EXPECT_LE(split(said({"--help"})).size(), help_lines);
}

TEST(Help, ShowsEveryOptionByHelpAll) {
  const std::string some = said({"train", "--help"}), all = said({"train", "--help-all"});
  EXPECT_NE(some.find("More options by --help-all: "), std::string::npos) << some;
  for (const char* option : {"--corpus", "--own-commands", "--dropout", "--history", "--json"})
    EXPECT_NE(all.find(option), std::string::npos) << option;
}

TEST(Help, NamesTheGroupsThatHaveNoRoom) {
  HelpText text{.usage = "x", .summary = "does x", .examples = "Examples:\n  x"};
  for (int i = 0; i < 60; ++i)
    text.options.push_back({.names = {"--o" + std::to_string(i)},
                            .place = "",
                            .value = "N",
                            .help = "an option",
                            .choices = {"1", "2"},
                            .group = i < 3 ? "Options" : "Many",
                            .fallback = "1",
                            .required = i == 0});
  const std::string page = help_page(text, false);
  EXPECT_EQ(page,
            "does x\nUsage: x\n\nOptions:\n  --o0 N        an option [1, 2; default 1; required]\n"
            "  --o1 N        an option [1, 2; default 1]\n  --o2 N        an option [1, 2; default 1]\n\n"
            "More options by --help-all: Many (57)\n\nExamples:\n  x\n");
  EXPECT_EQ(split(help_page(text, true)).size(), 2U + 2 + 3 + 2 + 57 + 3);
}

TEST(Help, ShowsEveryPageOfTheManual) {
  std::size_t pages = 0;
  for (const std::string& line : split(said({"help"}))) {
    if (!line.starts_with("  ")) continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    const Finished page = run_helper(WAYMARK_EXECUTABLE, {"help", name}, "");
    EXPECT_EQ(page.exit_code, 0) << name;
    EXPECT_GT(split(page.output).size(), 10U) << name;
    EXPECT_EQ(page.output.find("\x1b["), std::string::npos) << name << ": colours in a pipe";
    EXPECT_EQ(page.output.find("```"), std::string::npos) << name;
    EXPECT_EQ(page.output.find("]("), std::string::npos) << name;
    ++pages;
  }
  EXPECT_GE(pages, 12U);
  EXPECT_EQ(said({"help", "maps"}), said({"help", "maps-and-routes"}));
  EXPECT_EQ(said({"help", "plan"}), said({"plan", "--help"}));
  EXPECT_EQ(run_helper(WAYMARK_EXECUTABLE, {"help", "formulae"}, "").exit_code, 20);
}

TEST(Help, SetsTablesInColumnsWithinTheWidth) {
  const std::string page = said({"help", "formulas"});
  EXPECT_NE(page.find("  6      U[i:j]"), std::string::npos) << page;
  EXPECT_NE(page.find("||"), std::string::npos) << "an escaped bar is a bar";
  expect_narrow(page, "formulas");
}

}  // namespace
}  // namespace waymark::tools
