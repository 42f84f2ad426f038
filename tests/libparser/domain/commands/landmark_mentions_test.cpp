#include "libparser/domain/commands/landmark_mentions.hpp"

#include <gtest/gtest.h>

namespace waymark::parser {
namespace {

const std::vector<Landmark>& town() {
  static const std::vector<Landmark> landmarks{
      {"otter_bar", "Otter Bar", {}, {{"amenity", "pub"}, {"addr:street", "North Mill Street"}}},
      {"mill_stop", "N Mill St & Oak St", {}, {{"highway", "bus_stop"}}},
      {"oak_stop", "Oak St & N Mill St", {}, {{"highway", "bus_stop"}}},
      {"library", "Quince Library", {}, {{"amenity", "library"}}},
      {"bikes", "Bikes at Library Branch", {}, {{"amenity", "bicycle_rental"}}},
      {"college", "Pinewood College", {}, {{"amenity", "college"}}},
      {"hall", "Heron Theatre", {}, {{"amenity", "theatre"}, {"operator", "Pinewood College"}}},
      {"car_hire", "Cheap Lease Cars", {}, {{"shop", "car"}}},
      {"club", "Meteor Nightclub", {}, {{"amenity", "nightclub"}}},
      {"snacks", "Late Night Snacks", {}, {{"amenity", "fast_food"}}}};
  return landmarks;
}

// What the likeliest reading of a text names, in the order of the text.
std::vector<std::string> named(const std::string& text) {
  static const CityWords words(town());
  const auto lifts = lift_landmarks(text, words, {});
  std::vector<std::string> out;
  for (const std::size_t l : lifts.front().slots) out.push_back(town()[l].proposition);
  return out;
}

using Names = std::vector<std::string>;

TEST(LandmarkMentions, ADescriptionAfterANameIsOfTheSamePlace) {
  EXPECT_EQ(named("stay at Otter Bar on North Mill Street until you reach Quince Library"),
            (Names{"otter_bar", "library"}));
}

TEST(LandmarkMentions, TheOrderOfTheWordsTellsCrossingsApart) {
  EXPECT_EQ(named("go to Oak Street and North Mill Street"), (Names{"oak_stop"}));
  EXPECT_EQ(named("go to North Mill Street and Oak Street"), (Names{"mill_stop"}));
}

TEST(LandmarkMentions, ALoneNounNamesWhatIsOneRatherThanWhatIsCalledAfterOne) {
  EXPECT_EQ(named("walk to the library"), (Names{"library"}));
}

TEST(LandmarkMentions, AnOwnNameComesBeforeAnOperator) {
  EXPECT_EQ(named("visit Pinewood College"), (Names{"college"}));
}

TEST(LandmarkMentions, WordsOfCommandsAreNotMisspelledNames) {
  EXPECT_EQ(named("visit Otter Bar at least twice"), (Names{"otter_bar"}));
  EXPECT_EQ(named("visit Otter Bbar"), (Names{"otter_bar"}));
  EXPECT_EQ(named("visit the Heron Theatrre"), (Names{"hall"}));
}

TEST(LandmarkMentions, TwoWordsMayBeOneOfAName) {
  EXPECT_EQ(named("go to the night club"), (Names{"club"}));
  EXPECT_EQ(named("go to Pine Wood College"), (Names{"college"}));
}

}  // namespace
}  // namespace waymark::parser
