#include "libltl/vocabulary.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace waymark::ltl {
namespace {

TEST(Vocabulary, KeepsNamesOnceAndInOrder) {
  Vocabulary names({"chair", "sofa", "chair"});
  EXPECT_EQ(names.size(), 2U);
  EXPECT_EQ(names.add("lamp").index, 2U);
  EXPECT_EQ(names.add("sofa").index, 1U);
  EXPECT_EQ(names.name({2}), "lamp");
  EXPECT_EQ(names.find("stool"), std::nullopt);
  EXPECT_THROW(names.add(""), std::invalid_argument);
}

TEST(Vocabulary, FindsTheNameThatWasMeant) {
  const Vocabulary names({"chair", "ahead_chair", "sofa", "tee", "intersection"});
  const struct {
    const char *typed, *meant;
  } table[] = {{"chiar", "chair"}, {"chairs", "chair"},
               {"hair", "chair"},  {"Sofa", "sofa"},
               {"osfa", "sofa"},   {"intersecton", "intersection"},
               {"te", "tee"},      {"ahead_chiar", "ahead_chair"}};
  for (const auto& row : table) EXPECT_EQ(names.nearest(row.typed), row.meant) << row.typed;
  EXPECT_EQ(names.nearest("lamp"), std::nullopt);
  EXPECT_EQ(names.nearest("x"), std::nullopt);
  EXPECT_EQ(Vocabulary().nearest("chair"), std::nullopt);
}

}  // namespace
}  // namespace waymark::ltl
