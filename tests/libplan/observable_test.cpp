#include "libplan/world/labelling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Observable, EveryPropositionOfAMapIsReadAsWhatItWasMadeOf) {
  for (const char* map_name : {"grid", "jelly", "l"}) {
    const Map map = shipped(map_name);
    const std::vector<Observable> observables = observables_of(map.vocabulary());
    ASSERT_EQ(observables.size(), map.vocabulary().size());
    for (std::uint32_t p = 0; p < observables.size(); ++p) {
      const auto& [direction, kind, name] = observables[p];
      EXPECT_EQ(proposition_name(observables[p]), map.vocabulary().name({p}));
      EXPECT_EQ(kind == Kind::Object, has(map.objects(), name)) << map.vocabulary().name({p});
      EXPECT_EQ(kind == Kind::Floor, has(map.floors(), name)) << map.vocabulary().name({p});
      EXPECT_EQ(kind == Kind::Painting, has(map.walls(), name)) << map.vocabulary().name({p});
    }
  }
}

TEST(Observable, FormsByExample) {
  const ltl::Vocabulary vocabulary({"moved", "turned_right", "place_12", "next_tee", "left_wall", "dead_end"});
  const std::vector<Observable> want{
      {Direction::Here, Kind::Event, "moved"},    {Direction::Right, Kind::Event, "turned"},
      {Direction::Here, Kind::PlaceNumber, "12"}, {Direction::Next, Kind::NodeKind, "tee"},
      {Direction::Left, Kind::Passage, "wall"},   {Direction::Here, Kind::NodeKind, "dead_end"}};
  EXPECT_EQ(observables_of(vocabulary), want);
  EXPECT_EQ(proposition_name(mirrored(want[1])), "turned_left");
  EXPECT_EQ(proposition_name(mirrored(want[4])), "right_wall");
  EXPECT_EQ(mirrored(want[3]), want[3]);
}

TEST(Observable, UnknownFormsAreRefusedByName) {
  for (const char* name : {"ahead_", "next_wall", "open"}) {
    try {
      observables_of(ltl::Vocabulary({"moved", name}));
      ADD_FAILURE() << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("'" + std::string(name) + "'"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace waymark::plan
