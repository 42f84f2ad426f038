#include "libparser/domain/commands/word_forms.hpp"

#include <gtest/gtest.h>

#include <array>

namespace waymark::parser {
namespace {

using Pair = std::array<const char*, 2>;

bool related(const Pair& p) { return same_family(base_form(p[0]), base_form(p[1])); }

TEST(WordForms, InflectionsAndDerivedNounsAreOfOneFamily) {
  for (const Pair& p : {Pair{"run", "running"},
                        {"run", "ran"},
                        {"close", "closure"},
                        {"close", "closing"},
                        {"closed", "close"},
                        {"arrive", "arrival"},
                        {"confirm", "confirmation"},
                        {"ship", "shipment"},
                        {"apply", "application"},
                        {"carry", "carrie"},
                        {"drop", "dropped"},
                        {"dark", "darkness"},
                        {"written", "writing"},
                        {"sent", "sending"},
                        {"assert", "assertion"},
                        {"drop", "drop"}}) {
    EXPECT_TRUE(related(p)) << p[0] << ' ' << p[1];
    EXPECT_TRUE(related({p[1], p[0]})) << p[1] << ' ' << p[0];
  }
}

TEST(WordForms, WordsThatBeginAlikeAreOfSeveral) {
  for (const Pair& p : {Pair{"car", "care"},
                        {"move", "movie"},
                        {"bar", "barber"},
                        {"read", "ready"},
                        {"in", "inn"},
                        {"off", "offer"},
                        {"port", "porter"},
                        {"light", "lift"},
                        {"down", "done"},
                        {"cook", "cookie"}}) {
    EXPECT_FALSE(related(p)) << p[0] << ' ' << p[1];
    EXPECT_FALSE(related({p[1], p[0]})) << p[1] << ' ' << p[0];
  }
}

TEST(WordForms, APrefixMayNegate) {
  EXPECT_EQ(without_negation("unlocked"), "locked");
  EXPECT_EQ(without_negation("inactive"), "active");
  EXPECT_EQ(without_negation("disconnected"), "connected");
  EXPECT_EQ(without_negation("uni"), std::nullopt);
  EXPECT_EQ(without_negation("pump"), std::nullopt);
}

TEST(WordForms, ShortFormsAreBeginningsOrConsonants) {
  EXPECT_TRUE(is_short_form("lib", "library"));
  EXPECT_TRUE(is_short_form("msg", "message"));
  EXPECT_TRUE(is_short_form("rm", "room"));
  EXPECT_FALSE(is_short_form("li", "library"));
  EXPECT_FALSE(is_short_form("by", "bakery"));
  EXPECT_FALSE(is_short_form("rain", "rains"));
  EXPECT_FALSE(is_short_form("rum", "room"));
}

}  // namespace
}  // namespace waymark::parser
