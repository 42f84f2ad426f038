// The pages that this library answers for say what is so: docs/conventions.md and docs/formats/formulas.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "libltl/parse.hpp"
#include "libltl/print.hpp"

namespace waymark::ltl {
namespace {

namespace fs = std::filesystem;

const fs::path root = WAYMARK_SOURCE_DIR;

std::string contents(const fs::path& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in) << file;
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::string all_tests() {
  std::string out;
  for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".cpp" || entry.path().filename() == "CMakeLists.txt") out += contents(entry.path());
  }
  return out;
}

TEST(Documents, EveryTestThatConventionsNamesExists) {
  const std::string page = contents(root / "docs/conventions.md"), tests = all_tests();
  const std::regex name("`([A-Za-z_]+)\\.([A-Za-z_]+)`");
  std::size_t named = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), name), end; it != end; ++it, ++named) {
    const std::string suite = (*it)[1], test = (*it)[2];
    const bool found = tests.find("TEST(" + suite + ", " + test + ")") != std::string::npos ||
                       tests.find("TEST_F(" + suite + ", " + test + ")") != std::string::npos ||
                       (suite == "must_not_compile" && fs::exists(root / "tests" / suite / (test + ".cpp")));
    EXPECT_TRUE(found) << suite << "." << test;
  }
  EXPECT_GE(named, 20U);
}

// The rows of the two-column tables under that heading: | `left` | `right` |, where \| stands for |.
std::vector<std::pair<std::string, std::string>> rows_under(const std::string& heading) {
  std::istringstream page(contents(root / "docs/formats/formulas.md"));
  const std::regex row("\\| `(.*)` \\| `(.*)` \\|");
  std::vector<std::pair<std::string, std::string>> out;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.empty() || line[0] != '|') inside = false;
    if (line == heading) inside = true;
    std::smatch match;
    if (!inside || !std::regex_match(line, match, row)) continue;
    const auto bar = [](const std::string& s) { return std::regex_replace(s, std::regex("\\\\\\|"), "|"); };
    out.emplace_back(bar(match[1]), bar(match[2]));
  }
  return out;
}

void expect_read_alike(const std::string& heading, std::size_t rows, Notation left) {
  const auto table = rows_under(heading);
  EXPECT_EQ(table.size(), rows);
  for (const auto& [written, meant] : table) {
    Arena arena;
    EXPECT_EQ(parse(written, arena, {.notation = left}), parse(meant, arena))
        << written << " is not " << meant;
  }
}

TEST(Documents, FormulasAreReadAsTheTablesSay) {
  expect_read_alike("| written | read as |", 11, Notation::Infix);
  expect_read_alike("| prefix | infix |", 2, Notation::Lbt);
  expect_read_alike("| postfix | infix |", 2, Notation::Postfix);
}

TEST(Documents, FormulasAreWrittenAsTheTableSays) {
  const auto table = rows_under("| typed | written |");
  EXPECT_EQ(table.size(), 5U);
  for (const auto& [typed, written] : table) {
    Arena arena;
    EXPECT_EQ(print(parse(typed, arena)), written);
  }
}

}  // namespace
}  // namespace waymark::ltl
