// Properties of PRISM that are legal and rare, and those that are not answered, which are called by their name.
#include "libplan/model/formats/unanswered.hpp"

#include <gtest/gtest.h>

#include "libplan/solve/property_answer.hpp"

namespace waymark::plan {
namespace {

// State 1 loops, state 2 has no command; of the action `go` the second module never has its part.
const std::string model =
    "const double p = .25;\ndtmc\nmodule m s : [0..3]; [] s=0 -> p:(s'=1) + .75:(s'=2); [] s=1 -> true; "
    "[go] s=2 -> (s'=3); endmodule module n t : [0..1]; [go] t=1 -> true; endmodule\n"
    "rewards \"r\" s=0 : 4; s=1 : 1E-7; endrewards";

std::vector<PrismProperty> read(const std::string& properties) {
  return parse_prism_properties({model, ""}, {properties, ""});
}

TEST(Properties, NameDeadlocksAndFilterAsBefore) {
  const struct {
    std::string property;
    double value;
  } rows[] = {{"P=? [ F \"deadlock\" ]", 0.75},   {"P=? [ X \"init\" ]", 0},       {"P=? [ F s=2 {s=1} ]", 0},
              {"P=? [ F s=2 {\"init\"} ]", 0.75}, {"P=? [ F s=2 {s<3}{min} ]", 0}, {"P=? [ F s=1 {s<3}{max} ]", 1},
              {"P>=0.7 [ F s=2 {s=2} ]", 1},      {"P>=.8 [ F s=2 {s=0} ]", 0},    {"R=? [ I=1 {s=1} ]", 1e-7},
              {"S=? [ s=2 {s=0} ]", 0.75}};
  for (const auto& row : rows) {
    const std::vector<PrismProperty> all = read(row.property);
    ASSERT_EQ(all.size(), 1U);
    ASSERT_EQ(all[0].fault, "") << row.property;
    EXPECT_EQ(all[0].text, row.property);
    EXPECT_NEAR(answer(all[0], {.tolerance = 1e-9}).answer.value.middle(), row.value, 1e-8) << row.property;
  }
  const PropertyAnswer range = answer(read("P=? [ F s=2 {s<3}{min}{max} ]")[0], {});
  EXPECT_EQ(range.answer.value.lower, 0);
  EXPECT_EQ(range.range.value().lower, 1);
  EXPECT_EQ(answer(read("P>=1E-7 [ F s=1 ]")[0], {}).verdict, true);
}

TEST(Properties, AreCalledByTheirNamesWhereTheyAreNotAnswered) {
  const struct {
    std::string property, fault;
  } rows[] = {
      {"A [ G s<2 ]", "CTL: A [ … ] and E [ … ]"},
      {"P>=1 [ F E [ F s=1 ] ]", "CTL: A [ … ] and E [ … ]"},
      {"P=? [ F s=1 ] + 1", "arithmetic over operators"},
      {"P=? [ F s=1 ] >= P=? [ F s=2 ]", "arithmetic over operators"},
      {"1 - R{\"r\"}=? [ F s=1 ]", "arithmetic over operators"},
      {"\"reach\" * 2", "the value of another property, \"reach\", inside of this one"},
      {"<<1>> P=? [ F s=1 ]", "a coalition of players, <<…>>"},
      {"P=? [ F s=1 || F s=2 ]", "|| is not read: 'or' is written |, and conditional probabilities are not answered"},
      {"P>=0.5 [ F s=1 {s<3}{min} ]", "a filter {min} of truth values"},
      {"P=? [ F s=1 {P=? [ F s=2 ]} ]", "the states of a filter are a condition"},
      {"multi(P=? [ F s=1 {s=0} ])", "a filter inside of an objective"}};
  for (const auto& row : rows) {
    const std::vector<PrismProperty> all = read("\"reach\": P=? [ F s=1 ];\n" + row.property + ";\nP=? [ F s=1 ];");
    ASSERT_EQ(all.size(), 3U) << row.property;
    EXPECT_EQ(all[1].fault, row.fault) << row.property;
    EXPECT_EQ(all[1].text, row.property);
    EXPECT_EQ(all[0].fault + all[2].fault, "");
  }
}

}  // namespace
}  // namespace waymark::plan
