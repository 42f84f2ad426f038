// The pages that this library answers for say what is so: docs/conventions.md and docs/formats/formulas.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

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

// What stands in `code` on the page: \| inside a table stands for |.
std::vector<std::string> code_spans(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t open = text.find('`'); open != std::string::npos;) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string::npos) break;
    out.emplace_back();
    for (std::size_t i = open + 1; i < close; ++i)
      if (text.compare(i, 2, "\\|") != 0) out.back() += text[i];
    open = text.find('`', close + 1);
  }
  return out;
}

// "Suite.Name", both identifiers.
bool names_a_test(const std::string& code) {
  const auto dot = code.find('.');
  const auto odd = code.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_.");
  return dot != std::string::npos && dot > 0 && dot + 1 < code.size() && odd == std::string::npos;
}

TEST(Documents, EveryTestThatConventionsNamesExists) {
  const std::string tests = all_tests();
  std::size_t named = 0;
  for (const std::string& code : code_spans(contents(root / "docs/conventions.md"))) {
    if (!names_a_test(code)) continue;
    ++named;
    const std::string suite = code.substr(0, code.find('.')), test = code.substr(suite.size() + 1);
    const bool found = tests.find("TEST(" + suite + ", " + test + ")") != std::string::npos ||
                       tests.find("TEST_F(" + suite + ", " + test + ")") != std::string::npos ||
                       (suite == "must_not_compile" && fs::exists(root / "tests" / suite / (test + ".cpp")));
    EXPECT_TRUE(found) << code;
  }
  EXPECT_GE(named, 20U);
}

// The rows of the table of two code columns under that heading.
std::vector<std::pair<std::string, std::string>> rows_under(const std::string& heading) {
  std::istringstream page(contents(root / "docs/formats/formulas.md"));
  std::vector<std::pair<std::string, std::string>> out;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.empty() || line[0] != '|') inside = false;
    if (line == heading) inside = true;
    const std::vector<std::string> cells = code_spans(line);
    if (inside && cells.size() == 2) out.emplace_back(cells[0], cells[1]);
  }
  return out;
}

void expect_read_alike(const std::string& heading, std::size_t rows, Notation left,
                       Dialect dialect = Dialect::Waymark) {
  const auto table = rows_under(heading);
  EXPECT_EQ(table.size(), rows);
  for (const auto& [written, meant] : table) {
    Arena arena;
    EXPECT_EQ(parse(written, arena, {.dialect = dialect, .notation = left}), parse(meant, arena))
        << written << " is not " << meant;
  }
}

TEST(Documents, FormulasAreReadAsTheTablesSay) {
  expect_read_alike("| written | read as |", 18, Notation::Infix);
  expect_read_alike("| of Spot | read as |", 7, Notation::Infix, Dialect::Spot);
  expect_read_alike("| of NuSMV | read as |", 5, Notation::Infix, Dialect::Nusmv);
  expect_read_alike("| of PSL | read as |", 8, Notation::Infix, Dialect::Psl);
  expect_read_alike("| prefix | infix |", 2, Notation::Lbt);
  expect_read_alike("| postfix | infix |", 2, Notation::Postfix);
}

TEST(Documents, FormulasAreWrittenAsTheTableSays) {
  const auto table = rows_under("| typed | written |");
  EXPECT_EQ(table.size(), 7U);
  for (const auto& [typed, written] : table) {
    Arena arena;
    EXPECT_EQ(print(parse(typed, arena)), written);
  }
}

}  // namespace
}  // namespace waymark::ltl
