#include "libplan/motion/read_motion.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {
namespace {

TEST(ReadMotion, ReadsConfigurationsAndRadius) {
  const Motion expected{{{0.1, 0, 90}, {1, -2.5e-3, 359.5}}, Disc{0.05}};
  EXPECT_EQ(parse_motion(R"({"map":"l","motion":[[0.1,0,90],[1,-2.5e-3,359.5]],"radius":0.05})"), expected);
  EXPECT_EQ(parse_motion(R"({"motion":[],"radius":0})"), (Motion{{}, Disc{0}}));
}

TEST(ReadMotion, NamesWhatIsWrongAndWhere) {
  const struct {
    const char* text;
    const char* message;
    std::size_t line, column;
  } table[] = {
      {"", "malformed JSON", 1, 1},
      {"{\"motion\":[}", "malformed JSON", 1, 12},
      {"[]", "expected an object", 1, 1},
      {"{\"motion\":[]}", "the key \"radius\" is missing", 1, 1},
      {"{\"motion\":3,\"radius\":0}", "motion: expected a list", 1, 11},
      {"{\"motion\":[],\n \"radius\":\"0\"}", "radius: expected a number", 2, 11},
      {"{\"motion\":[[0,0,0],[1,2]],\"radius\":0}", "motion[1]: expected a configuration [x,y,heading]", 1, 20},
      {"{\"motion\":[\n[0,null,0]],\"radius\":0}", "motion[0][1]: expected a number", 2, 4},
      {"{\"motion\":[[1e999,0,0]],\"radius\":0}", "a number of the JSON text is out of range", 0, 0},
  };
  for (const auto& row : table) try {
      parse_motion(row.text, "m.json");
      ADD_FAILURE() << row.text << " was read";
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << row.text << ": " << error.what();
      EXPECT_EQ(error.line(), row.line) << row.text;
      EXPECT_EQ(error.column(), row.column) << row.text;
    }
}

}  // namespace
}  // namespace waymark::plan
