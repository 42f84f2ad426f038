// Recorded commands: how they are read, and when a line is the one that was recorded.
#include "tools/shell/transcript.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

using Words = std::vector<std::string>;

TEST(Transcript, HasStepsWithWhatTheyPrinted) {
  const auto steps = parse_transcript(
      "# one\n$ waymark parse 'F a'  --json\nx\n\ny\n[exit 0]\n# slow\n\n$ waymark random > r.ltl\n[exit 10]\n", "t");
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].line, 2U);
  EXPECT_EQ(steps[0].arguments, (Words{"parse", "F a", "--json"}));
  EXPECT_EQ(steps[0].printed, (Words{"x", "", "y"}));
  EXPECT_FALSE(steps[0].slow);
  EXPECT_EQ(steps[1].arguments, Words{"random"});
  EXPECT_EQ(steps[1].output, "r.ltl");
  EXPECT_EQ(steps[1].exit_code, 10);
  EXPECT_TRUE(steps[1].slow);
}

TEST(Transcript, SaysWhereItIsWrong) {
  const auto line = [](const char* text) -> std::size_t {
    try {
      (void)parse_transcript(text, "t");
    } catch (const ltl::FormatError& error) {
      return error.line();
    }
    return 0;
  };
  EXPECT_EQ(line("# a\nwaymark parse\n"), 2U);
  EXPECT_EQ(line("$ waymark parse\nF a\n"), 2U);
  EXPECT_EQ(line("$ waymark parse 'F\n[exit 0]\n"), 1U);
  EXPECT_EQ(line("$ waymark parse\n[exit x]\n"), 2U);
}

TEST(Transcript, LinesAgreeButForWhatIsMeasured) {
  EXPECT_TRUE(agrees("all   99.00", "all 99.00"));
  EXPECT_FALSE(agrees("all 99.00", "all 99.01"));
  EXPECT_FALSE(agrees("all 99.00", "all 99.00 300"));
  EXPECT_TRUE(agrees("took MEASURED s, 3 lines", "took 1.5e-3 s, 3 lines"));
  EXPECT_FALSE(agrees("took MEASURED s, 3 lines", "took 1.5 s, 4 lines"));
  EXPECT_FALSE(agrees("took MEASURED s", "took long s"));
  EXPECT_FALSE(agrees("took MEASURED s", "took"));
  EXPECT_TRUE(agrees(R"({"s":{MEASURED},"n":2})", R"({"s":{"a":1,"b":2},"n":2})"));
  EXPECT_FALSE(agrees(R"({"s":{MEASURED},"n":2})", R"({"s":{"a":1,"b":2},"n":3})"));
  EXPECT_TRUE(agrees("MEASURED MEASURED", "1 2"));
  EXPECT_FALSE(agrees("MEASURED MEASURED", "1"));
}

}  // namespace
}  // namespace waymark::tools
