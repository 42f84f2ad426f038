// What `waymark draw` draws of every kind, and routes in characters.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tools/shell/data_directory.hpp"
#include "tools/shell/process.hpp"

namespace waymark::tools {
namespace {

Finished drawn(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "draw");
  return run_helper(WAYMARK_EXECUTABLE, arguments, "");
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Draw, DrawsEveryKind) {
  const std::vector<std::string> task{"--map", "grid", "--start", "1,9,0", "--formula", "F easel", "--svg", "-"};
  for (const char* kind : {"map", "route", "lasso", "formula", "automaton", "product", "policy", "values"}) {
    const bool graph = kind[0] == 'f' || kind[0] == 'a' || std::string(kind) == "product";
    if (graph && helper("waymark-layout").empty()) continue;
    std::vector<std::string> arguments{kind};
    arguments.insert(arguments.end(), task.begin(), task.end());
    const Finished picture = drawn(arguments);
    EXPECT_EQ(picture.exit_code, 0) << kind;
    EXPECT_NE(picture.output.find("<svg"), std::string::npos) << kind;
    EXPECT_TRUE(picture.output.ends_with("</svg>\n")) << kind;
  }
}

TEST(Draw, TreeHasANodeForEveryOperatorAndProposition) {
  if (helper("waymark-layout").empty()) GTEST_SKIP() << "built without Graphviz";
  for (const auto& [formula, nodes] : std::vector<std::pair<std::string, std::size_t>>{
           {"a", 1}, {"F a", 2}, {"G(a & F b)", 5}, {"a U (b U X !c)", 7}, {"F a & F a", 2}})
    EXPECT_EQ(count(drawn({"formula", "--formula", formula, "--svg", "-"}).output, "class=\"node\""), nodes) << formula;
}

TEST(Draw, PolicyHasAnArrowWhereAnActionIsTakenAndValuesANumber) {
  const std::vector<std::string> task{"--map", "grid", "--start", "1,9,0", "--formula", "F easel", "--svg", "-"};
  std::vector<std::string> values{"values"}, policy{"policy"};
  values.insert(values.end(), task.begin(), task.end());
  policy.insert(policy.end(), task.begin(), task.end());
  const std::string fields = "stroke-width=\"0.6\"", arrows = "stroke-width=\"1.7\"";
  const std::string numbered = drawn(values).output, arrowed = drawn(policy).output;
  EXPECT_GT(count(numbered, fields), 20U);
  EXPECT_EQ(count(numbered, fields), count(arrowed, fields));
  EXPECT_EQ(count(numbered, arrows), 0U);
  EXPECT_EQ(count(arrowed, arrows), count(arrowed, fields));  // everywhere something is to be done before the easel
}

// Every step of a route is a heavy line between two places: three characters from west to east, one from north to
// south.
TEST(Draw, RouteInCharactersHasAllItsSteps) {
  for (const std::string formula : {"F easel", "F chair & F lamp", "F sofa"}) {
    const std::string text =
        drawn({"route", "--map", "grid", "--start", "1,9,0", "--formula", formula, "--terminal"}).output;
    const auto legend = text.rfind("\n\n");
    ASSERT_NE(legend, std::string::npos);
    const std::string picture = text.substr(0, legend);
    const std::string plan =
        run_helper(WAYMARK_EXECUTABLE, {"plan", formula, "--map", "grid", "--start", "1,9,0", "--json"}, "").output;
    EXPECT_EQ(count(picture, "@"), 1U) << picture;
    EXPECT_EQ(count(picture, "=") % 3, 0U) << picture;
    EXPECT_GT(count(picture, "===") + count(picture, "H"), 0U) << picture << plan;
    EXPECT_EQ(text.find("\x1b["), std::string::npos) << "colours in a pipe";
    std::size_t widest = 0, length = 0;
    for (const char c : text) length = c == '\n' ? 0 : length + 1, widest = std::max(widest, length);
    EXPECT_LE(widest, 100U);
  }
}

}  // namespace
}  // namespace waymark::tools
