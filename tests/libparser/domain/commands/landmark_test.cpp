#include "libparser/domain/commands/landmark.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

std::filesystem::path written(const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "landmark_test.json";
  std::ofstream(file) << text;
  return file;
}

TEST(ReadPropositions, APropositionHasANameTagsAndADescription) {
  const auto all = read_propositions(written(R"({"propositions": {
    "charger": {}, "depot": "where parcels are stored",
    "lab_2": {"name": "wet lab", "other_names": ["chemistry"],
              "tags": {"floor": "green"}, "description": "smells"}}})"));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].name, "charger");
  EXPECT_TRUE(all[0].tags.empty());
  EXPECT_EQ(all[1].proposition, "depot");
  EXPECT_EQ(all[1].name, "depot");
  EXPECT_EQ(all[1].tags.at(description_tag), "where parcels are stored");
  EXPECT_EQ(all[2].name, "wet lab");
  EXPECT_EQ(all[2].other_names, (std::vector<std::string>{"chemistry"}));
  EXPECT_EQ(all[2].tags.at("floor"), "green");
  EXPECT_EQ(all[2].tags.at(description_tag), "smells");
}

TEST(ReadPropositions, WithoutANameAPropositionIsCalledAsItReads) {
  EXPECT_EQ(read_propositions(written(R"({"propositions": {"wet_lab_2": {}}})")).front().name, "wet lab 2");
}

TEST(ReadPropositions, WhatIsWrongIsSaid) {
  EXPECT_THROW((void)read_propositions(written("{}")), ltl::FormatError);
  EXPECT_THROW((void)read_propositions(written(R"({"propositions": {"a": 3}})")), ltl::FormatError);
  EXPECT_THROW((void)read_propositions(written("{\"propositions\"")), ltl::FormatError);
}

}  // namespace
}  // namespace waymark::parser
