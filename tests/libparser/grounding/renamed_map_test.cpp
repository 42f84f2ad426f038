#include "libparser/grounding/renamed_map.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/print.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/hallways/hallway_things.hpp"
#include "libplan/world/trajectory.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/generate.hpp"

namespace waymark::parser {
namespace {

plan::Map home() {
  using plan::Edge, plan::Node;
  return {"home",
          {Node{0, 0, "kitchen", 2}, Node{1, 0, "meeting room", {}}, Node{2, 0, "sofa", 9}, Node{1, 1, {}, {}}},
          {Edge{0, 1, "tiles", "cow"}, Edge{1, 2, "carpet", ""}, Edge{1, 3, "blue", "fish"}},
          {"kitchen", "meeting room", "sofa"},
          {"blue", "carpet", "tiles"},
          {"cow", "fish"}};
}

RenamedMap renamed(const plan::Map& map, const std::string& text) {
  const HallwayThings things(map.vocabulary());
  const std::vector<std::string> tokens = tokenize(text);
  return {shipped_maps()[0].vocabulary(), map, tokens, find_mentions(tokens, things.things()), things.things()};
}

TEST(RenamedMap, HasTheVocabularyOfTheTrainingAndKeepsWhatBothKnow) {
  const plan::Map map = home();
  const RenamedMap other = renamed(map, "turn left at the kitchen and follow the carpet to the sofa");
  EXPECT_EQ(other.map().vocabulary(), shipped_maps()[0].vocabulary());
  EXPECT_EQ(other.map().nodes()[2].object, "sofa");
  EXPECT_EQ(other.map().edges()[2].floor, "blue");
  EXPECT_EQ(other.text(), "turn left at the barstool and follow the brick hallway to the sofa");
}

// w ⊨ f on the renamed map iff w ⊨ f in its own names on the map that was given, for random formulas and walks.
TEST(RenamedMap, FormulasMeanTheSameInTheirOwnNames) {
  const plan::Map map = home();
  const RenamedMap other = renamed(map, "go past the meeting room");
  ASSERT_EQ(other.map().poses(), map.poses());
  ltl::Random random(7);
  std::size_t hold = 0, fail = 0;
  for (int round = 0; round < 3'000; ++round) {
    ltl::Arena theirs(other.map().vocabulary()), ours(map.vocabulary());
    const ltl::Formula f = ltl::random_formula(
        random, theirs, {.size = 1 + random.below(8), .atoms = theirs.vocabulary().size(), .weak_next = true});
    plan::Trajectory walk{{plan::PoseId{static_cast<std::uint32_t>(random.below(map.poses()))}}, {}};
    for (std::size_t i = random.below(6); i > 0; --i) {
      const plan::Action action = plan::all_actions[random.below(plan::all_actions.size())];
      const auto next = map.successor(walk.poses.back(), action);
      if (!next) continue;
      walk.poses.push_back(*next);
      walk.actions.push_back(action);
    }
    const ltl::Formula g = other.in_own_names(f, ours);
    // A place number that the vocabulary needs stands on the renamed map alone.
    bool numbered = false;
    for (const ltl::Proposition p : ltl::propositions(f))
      numbered = numbered || theirs.vocabulary().name(p).starts_with("place_");
    if (numbered) continue;
    const bool expected = ltl::holds(plan::word_of(walk, other.map()), f);
    ASSERT_EQ(ltl::holds(plan::word_of(walk, map), g), expected)
        << ltl::print(f) << " as " << ltl::print(g) << " on " << plan::show(walk, map);
    ++(expected ? hold : fail);
  }
  EXPECT_GT(hold, 300U);
  EXPECT_GT(fail, 300U);
}

}  // namespace
}  // namespace waymark::parser
