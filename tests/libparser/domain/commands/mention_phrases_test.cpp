#include "libparser/domain/commands/mention_phrases.hpp"

#include <gtest/gtest.h>

#include "libparser/domain/commands/landmark_mentions.hpp"

namespace waymark::parser {
namespace {

const std::vector<Landmark>& plant() {
  static const std::vector<Landmark> landmarks{{"hatch", "the hatch is open", {}, {}},
                                               {"fan", "the fan runs", {}, {}},
                                               {"lamp", "the lamp is on", {}, {}},
                                               {"parcel", "a parcel arrives", {}, {}},
                                               {"cart", "the cart is in its bay", {}, {}},
                                               {"fog", "it is foggy", {}, {}},
                                               {"depot", "the repair depot", {}, {}},
                                               {"bay_2", "loading bay 2", {}, {}},
                                               {"tavern", "Ida's tavern", {}, {}},
                                               {"valve.shut", "valve.shut", {}, {}},
                                               {"req_3", "req_3", {}, {}}};
  return landmarks;
}

// The likeliest reading, with propositions for slots.
std::string read(const std::string& text) {
  static const CityWords words(plant());
  const LandmarkLift lift = lift_landmarks(text, words, {}).front();
  std::string out;
  for (const std::string& token : lift.text.tokens) {
    if (!out.empty()) out += ' ';
    out += token[0] == '#' ? '<' + plant()[lift.slots[std::stoul(token.substr(1)) - 1]].proposition + '>' : token;
  }
  return out;
}

TEST(MentionPhrases, ClausesAreFoundInOtherForms) {
  EXPECT_EQ(read("whenever the fan runs"), "whenever <fan>");
  EXPECT_EQ(read("no running fan"), "no <fan>");
  EXPECT_EQ(read("the fan has been running"), "<fan>");
  EXPECT_EQ(read("the arrival of a parcel"), "<parcel>");
  EXPECT_EQ(read("opening of the hatch must follow"), "<hatch> must follow");
  EXPECT_EQ(read("until there is a parcel arriving"), "until <parcel>");
  EXPECT_EQ(read("the lamp must be on , always"), "<lamp> , always");
}

TEST(MentionPhrases, WordsInsideMayStateTheOpposite) {
  EXPECT_EQ(read("the hatch isn't open"), "not <hatch>");
  EXPECT_EQ(read("the hatch is shut"), "not <hatch>");
  EXPECT_EQ(read("the hatch is not shut"), "<hatch>");
  EXPECT_EQ(read("a closed hatch"), "not <hatch>");
  EXPECT_EQ(read("lamp off"), "not <lamp>");
  EXPECT_EQ(read("an unopened hatch"), "not <hatch>");
  EXPECT_EQ(read("the cart is outside its bay"), "not <cart>");
  EXPECT_EQ(read("not the lamp on"), "not <lamp>");
}

TEST(MentionPhrases, ShortFormsNumbersAndMisspellings) {
  EXPECT_EQ(read("go to the rep depot"), "go to <depot>");
  EXPECT_EQ(read("go to loading bay two"), "go to <bay_2>");
  EXPECT_EQ(read("the fan runing"), "<fan>");
  EXPECT_EQ(read("drop by idas tavern"), "drop by <tavern>");
  EXPECT_EQ(read("drop by ida's"), "drop by <tavern> s");
}

TEST(MentionPhrases, IdentifiersStandForThemselves) {
  EXPECT_EQ(read("after req_3 always valve.shut."), "after <req_3> always <valve.shut> .");
  EXPECT_EQ(read("after \"req_3\" never `valve.shut`"), "after <req_3> never <valve.shut>");
}

TEST(MentionPhrases, NamesOfPlacesHaveNoOpposites) {
  static const CityWords words(std::vector<Landmark>{{"open", "Open House", {}, {}}});
  for (const MentionPhrase& phrase : mention_phrases({"the", "house", "is", "not", "shut"}, words, Synonyms())) {
    EXPECT_FALSE(phrase.negated);
    EXPECT_EQ(phrase.end, 2U);
  }
}

}  // namespace
}  // namespace waymark::parser
