#include "libparser/lexicon/synonyms.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace waymark::parser {
namespace {

using Phrases = std::vector<std::string>;

TEST(Synonyms, ShareAGroup) {
  const Synonyms synonyms({"couch, lounge, sofa", "bar, lounge", "movie house, cinema"});
  EXPECT_EQ(synonyms.of("sofa"), (Phrases{"couch", "lounge"}));
  EXPECT_EQ(synonyms.of("lounge"), (Phrases{"bar", "couch", "sofa"}));
  EXPECT_EQ(synonyms.of("cinema"), (Phrases{"movie house"}));
  EXPECT_TRUE(synonyms.of("movie").empty());
  EXPECT_EQ(synonyms.groups().size(), 3U);
}

TEST(Synonyms, OfWordNetAreShipped) {
  std::ifstream file(WAYMARK_SOURCE_DIR "/data/words/synonyms.txt");
  Phrases groups;
  for (std::string line; std::getline(file, line);) groups.push_back(line);
  const Synonyms synonyms(groups);
  EXPECT_EQ(synonyms.of("sofa"), (Phrases{"couch", "lounge"}));
  for (const std::string& group : groups) EXPECT_NE(group.find(", "), std::string::npos) << group;
}

}  // namespace
}  // namespace waymark::parser
