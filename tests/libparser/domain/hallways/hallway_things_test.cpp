#include "libparser/domain/hallways/hallway_things.hpp"

#include <gtest/gtest.h>

#include "libltl/text/parse.hpp"
#include "libparser/corpus/token.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::parser {
namespace {

struct Hallway {
  plan::Map map = plan::read_map("grid", WAYMARK_SOURCE_DIR "/data");
  HallwayThings things{map.vocabulary()};
  ltl::Arena arena{map.vocabulary()};

  std::string text(const std::string& said) const {
    std::string out;
    for (const std::string& token : things.lift(tokenize(said)).text.tokens) out += (out.empty() ? "" : " ") + token;
    return out;
  }
  // What a lifted formula denotes, with slots of what is said.
  std::optional<ltl::Formula> formula(const std::string& said, const char* lifted) {
    const LiftedMentions mentions = things.lift(tokenize(said));
    return formula_of(parse_lifted(lifted), things.bindings(arena, mentions.things, 7));
  }
};

TEST(HallwayThings, AreMentionedByNamesAndKindsOfPlaces) {
  const Hallway hall;
  EXPECT_EQ(hall.text("go to the chair and then to the lamp"), "go to #1 and then to #2");
  EXPECT_EQ(hall.text("follow the hall with the blue floor to the easel"), "follow #1 to #2");
  EXPECT_EQ(hall.text("visit positions 2 and 6"), "visit #1 and #2");
  EXPECT_EQ(hall.text("go to the chair without crossing the blue hall"), "go to #1 without crossing #2");
  EXPECT_EQ(hall.text("stop at the crossing"), "stop at #1");
  EXPECT_TRUE(hall.things.lift({"chair"}).text.scope.spatial);
}

TEST(HallwayThings, AreCalledBySynonymsThatNameNothingElse) {
  const plan::Map map = plan::read_map("grid", WAYMARK_SOURCE_DIR "/data");
  const Synonyms synonyms({"lamp, torchere", "chair, lamp, seat", "hall, blue"});
  const HallwayThings things(map.vocabulary(), &synonyms);
  const auto text = [&](const char* said) { return things.lift(tokenize(said)); };
  EXPECT_EQ(text("go to the torchere").text.tokens, (std::vector<std::string>{"go", "to", "#1"}));
  EXPECT_EQ(things.things()[text("go to the lamp").things.front()].name, "lamp");
  EXPECT_EQ(things.things()[text("go to the chair").things.front()].name, "chair");
  EXPECT_TRUE(text("follow the hall").things.empty());
}

TEST(HallwayThings, DenotePropositionsOfTheMap) {
  Hallway hall;
  const auto same = [&](const char* said, const char* lifted, const char* formula) {
    EXPECT_EQ(hall.formula(said, lifted), ltl::parse(formula, hall.arena)) << said;
  };
  same("the chair", "eventually #1", "F chair");
  same("the chair", "eventually ahead #1", "F ahead_chair");
  same("the blue floor", "stayon #1", "G(moved -> behind_blue)");
  same("place 4", "eventually #1", "F place_4");
  same("the chair", "sequence #1 start end", "F(chair & F place_7)");
  EXPECT_FALSE(hall.formula("the chair", "eventually along #1"));  // nobody walks along a chair
  EXPECT_FALSE(hall.formula("the chair", "eventually #2"));
}

TEST(HallwayThings, OfAllMapsAreMentionedByTheirNames) {
  for (const char* name : {"grid", "jelly", "l"}) {
    const plan::Map map = plan::read_map(name, WAYMARK_SOURCE_DIR "/data");
    const HallwayThings things(map.vocabulary());
    ltl::Arena arena(map.vocabulary());
    ASSERT_FALSE(things.things().empty());
    for (const NamedThing& thing : things.things()) {
      const LiftedMentions mentions = things.lift(thing.phrases.front());
      ASSERT_EQ(mentions.things.size(), 1U) << thing.name;
      EXPECT_EQ(things.things()[mentions.things.front()].name, thing.name);
      EXPECT_TRUE(formula_of(parse_lifted("eventually #1"), things.bindings(arena, mentions.things, {}))) << thing.name;
    }
  }
}

TEST(PlaceNumbers, AreOfOnePlaceOrNone) {
  const plan::Map map = plan::read_map("grid", WAYMARK_SOURCE_DIR "/data");
  std::vector<plan::PoseId> one, two;
  for (std::uint32_t i = 0; i < map.poses(); ++i) {
    const auto place = map.nodes()[map.node_of({i})].place;
    const std::vector<plan::PoseId> poses{{i}, {i}};
    ASSERT_EQ(place_number(map, poses).has_value(), place.has_value());
    if (place && *place == 4) one.push_back({i});
    if (place) two.push_back({i});
  }
  EXPECT_EQ(place_number(map, one), 4U);
  EXPECT_FALSE(place_number(map, two));
  EXPECT_FALSE(place_number(map, {}));
}

}  // namespace
}  // namespace waymark::parser
