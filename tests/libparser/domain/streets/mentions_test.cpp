#include "libparser/domain/streets/mentions.hpp"

#include <gtest/gtest.h>

#include "libparser/corpus/token.hpp"
#include "libparser/domain/streets/street_directions.hpp"
#include "libparser/domain/streets/street_readings.hpp"
#include "tests/libparser/domain/streets/town.hpp"

namespace waymark::streets {
namespace {

std::string show(const std::vector<Mention>& mentions) {
  const StreetMap map = town();
  std::string out;
  for (const Mention& mention : mentions) {
    out += "[";
    for (const NameFit& fit : mention.fits) out += (out.back() == '[' ? "" : "|") + map.landmarks[fit.landmark].name;
    out += "]";
  }
  return out;
}

TEST(Mentions, AreFoundMisspeltShortenedAndShared) {
  const StreetMap map = town();
  const CommonWords common{"go", "to", "the", "from", "then", "old", "new", "will", "and"};
  MentionFinder finder(map, common);
  const std::pair<const char*, const char*> rows[] = {
      {"go from the church to the museum", "[Church][Museum]"},
      {"Go to the Musuem, then the bakry", "[Museum][Bakery]"},  // slips of a letter
      {"from cafe nino to CAFÉ", "[Café Niño][Café Niño]"},      // accents, a part of a name
      {"go to the old mill and the new mill", "[Old Mill][New Mill]"},
      {"go to the newmill", "[New Mill]"},         // written together
      {"go to the mill", "[New Mill|Old Mill]"},   // shared: both are kept
      {"go to the old one", ""},                   // a common word names nothing
      {"you will go to the well", "[Well|Wall]"},  // "will" is a common word, "wall" is near
  };
  for (const auto& [text, expected] : rows) {
    std::string found = show(finder.find(parser::tokenize(text)));
    if (found == "[Old Mill|New Mill]") found = "[New Mill|Old Mill]";
    EXPECT_EQ(found, expected) << text;
  }
}

TEST(Mentions, SlipsAreCountedByTheDefinition) {
  EXPECT_EQ(slips("", "abc"), 3U);
  EXPECT_EQ(slips("museum", "musuem"), 1U);  // neighbours exchanged
  EXPECT_EQ(slips("mill", "mil"), 1U);
  EXPECT_EQ(slips("bakery", "battery"), 2U);
  EXPECT_EQ(slips("wall", "well"), 1U);
  EXPECT_EQ(slips("abc", "abc"), 0U);
}

TEST(Mentions, CommonWordsAreThoseOfSeveralCities) {
  const std::vector<StreetMap> maps{town(), parse_street_map(R"({"name": "other", "nodes": [
    {"id": 0, "name": "Go Cafe", "u": 0, "v": 0}, {"id": 1, "name": "Pond", "u": 1, "v": 0}], "edges": []})")};
  StreetInstruction here, there;
  here.tokens = parser::tokenize("go north to the church");
  there.tokens = parser::tokenize("go north past the pond");
  there.map = 1;
  const std::vector<const StreetInstruction*> both{&here, &there};
  const CommonWords common = common_words(both, maps);
  EXPECT_EQ(common, (CommonWords{"north", "the"}));  // "go" is part of a name in one of the two
}

std::vector<StreetRoute> sequences(const std::string& text, LandmarkIndex start) {
  const StreetMap map = town();
  const CommonWords common{"go", "to", "the", "from", "then", "old", "new", "and", "via", "past"};
  const auto tokens = parser::tokenize(text);
  const auto mentions = MentionFinder(map, common).find(tokens);
  std::vector<StreetRoute> out;
  for (const Interpretation& reading : readings(start, place(mentions, {start}), mention_cues(tokens, mentions)))
    out.push_back(reading.landmarks);
  return out;
}

TEST(Readings, FollowWhatIsSaidOfOrder) {
  const auto has = [](const std::vector<StreetRoute>& all, const StreetRoute& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  EXPECT_EQ(sequences("from the church go to the bakery then the well", church),
            (std::vector<StreetRoute>{{church, bakery, well}}));
  EXPECT_EQ(sequences("start at the bakery then the well", church),
            (std::vector<StreetRoute>{{church, bakery, well}, {church, well}}));  // or: a neighbour of the start
  const auto via = sequences("from the church go to the museum via the bakery and the old mill .", church);
  EXPECT_TRUE(has(via, {church, bakery, old_mill, museum}));
  EXPECT_TRUE(has(via, {church, museum, bakery, old_mill}));  // as it stands, too
  const auto from = sequences("go to the museum from the church", church);
  EXPECT_EQ(from.front(), (StreetRoute{church, museum}));
  const auto past = sequences("from the church go past the bakery to the museum", church);
  EXPECT_TRUE(has(past, {church, museum}));
  EXPECT_TRUE(has(past, {church, bakery, museum}));
  const auto without = sequences("go to the museum without going to the bakery", church);
  EXPECT_TRUE(has(without, {church, museum}));
  const auto instead = sequences("do not stop at the bakery , go to the museum", church);
  EXPECT_TRUE(has(instead, {church, museum}));  // the denial ends with its clause
  EXPECT_FALSE(has(instead, {church}));
}

TEST(Readings, SpeakOfEveryCandidateOnTheirOwn) {
  EXPECT_EQ(sequences("", church), (std::vector<StreetRoute>{{church}}));
  EXPECT_EQ(sequences("from the church", church).front(), (StreetRoute{church}));
  EXPECT_EQ(sequences("via the bakery", church).front(), (StreetRoute{church, bakery}));
}

TEST(Directions, AreReadFromCompassClockAndSides) {
  const std::pair<const char*, double> rows[] = {
      {"go north", 90},    {"head south west", -135}, {"southeast", -45},        {"up and to the left", 135},
      {"go 3 o'clock", 0}, {"at 12 oclock", -270},    {"north then go east", 0}, {"go 6oclock", -90}};
  for (const auto& [text, angle] : rows) {
    const auto tokens = parser::tokenize(text);
    const auto found = last_direction(tokens, 0, tokens.size());
    ASSERT_TRUE(found) << text;
    EXPECT_NEAR(angle_between(found->angle, angle), 0, 1e-9) << text << " read as " << found->angle;
  }
  const auto none = parser::tokenize("go to the 36th church");
  EXPECT_FALSE(last_direction(none, 0, none.size()));
}

}  // namespace
}  // namespace waymark::streets
