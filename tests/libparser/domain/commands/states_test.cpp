#include "libparser/domain/commands/states.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libparser/domain/commands/word_forms.hpp"

namespace waymark::parser {
namespace {

// "same", "opposite", "both" or "" for two words.
std::string relation(const std::string& word, const std::string& other) {
  bool same = false, opposite = false;
  for (const RelatedState& related : related_states(word))
    if (related.word == base_form(other)) (related.opposite ? opposite : same) = true;
  return same && opposite ? "both" : same ? "same" : opposite ? "opposite" : "";
}

TEST(States, WordsSayTheSameOrTheOpposite) {
  EXPECT_EQ(relation("shut", "closed"), "same");
  EXPECT_EQ(relation("open", "shut"), "opposite");
  EXPECT_EQ(relation("opening", "shut"), "opposite");
  EXPECT_EQ(relation("on", "off"), "opposite");
  EXPECT_EQ(relation("up", "down"), "opposite");
  EXPECT_EQ(relation("full", "empty"), "opposite");
  EXPECT_EQ(relation("inside", "outside"), "opposite");
  EXPECT_EQ(relation("green", "full"), "");
  EXPECT_TRUE(related_states("bookcase").empty());
}

TEST(States, RelationsAreSymmetric) {
  for (const char* word : {"open", "on", "up", "high", "full", "idle", "green", "dark", "apply", "wet", "alive"})
    for (const RelatedState& related : related_states(word)) {
      const auto back = related_states(related.word);
      EXPECT_TRUE(std::any_of(back.begin(), back.end(),
                              [&](const RelatedState& other) {
                                return same_family(other.word, word) && other.opposite == related.opposite;
                              }))
          << word << ' ' << related.word;
    }
}

}  // namespace
}  // namespace waymark::parser
