#include "libltl/rewriting/without_past.hpp"

#include <gtest/gtest.h>

#include "libltl/structure/fragment.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::ltl {
namespace {

TEST(WithoutPast, KnowsHistoriesThatLettersDetermine) {
  const struct {
    const char* formula;
    bool determined;
  } table[] = {
      {"a", true},          {"F a", true},          {"a & Y b", true},    {"F (a S b)", true},
      {"Y a U O b", true},  {"Y X a", false},       {"O F a", false},     {"b & O F a", false},
      {"O F a & b", false}, {"F (a S X b)", false}, {"b U Y F a", false}, {"H (a | Y (b U a))", false},
  };
  for (const auto& row : table) {
    Arena from(Vocabulary({"a", "b"})), to(Vocabulary({"a", "b"}));
    const WithoutPast found = without_past(parse(row.formula, from), to);
    EXPECT_EQ(found.determined, row.determined) << row.formula;
    EXPECT_FALSE(has_past(found.formula)) << row.formula;
    EXPECT_EQ(to.vocabulary().size() > 2, has_past(parse(row.formula, from))) << row.formula;
  }
}

}  // namespace
}  // namespace waymark::ltl
