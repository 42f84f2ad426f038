#include "libplan/world/observable_english.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "libltl/english/read_english.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

TEST(ObservableEnglish, NoTwoPropositionsHaveTheSamePhrase) {
  const ltl::Vocabulary vocabulary = hallway(3).vocabulary();
  const auto describe = hallway_english(vocabulary);
  std::set<std::string> phrases;
  for (std::uint32_t p = 0; p < vocabulary.size(); ++p) {
    EXPECT_TRUE(phrases.insert(describe({p}).holds).second) << vocabulary.name({p});
    EXPECT_TRUE(phrases.insert(describe({p}).fails).second) << vocabulary.name({p});
  }
}

struct Row {
  const char *formula, *english;
};

TEST(ObservableEnglish, FormulasOfInstructionsAreReadBack) {
  const Row table[] = {
      {"X(turned_left & X(moved & X(moved & F chair)))", "turn left, then go forward 2 times, then go to the chair."},
      {"X(moved U (moved & chair & left_fish))",
       "go forward until you are at the chair and the fish painting is to your left."},
      {"F(blue & X((turned_left | turned_right) U ((turned_left | turned_right) & ahead_wall)))",
       "go to the blue floor, then turn left or turn right until there is a wall ahead."},
      {"!blue U chair", "do not step on the blue floor until you are at the chair."},
      {"!blue & X((moved & !blue) U (moved & chair))",
       "while you are not on the blue floor, go forward until you are at the chair."},
      {"F chair & G !brick", "go to the chair; never step on the brick floor."},
  };
  const ltl::Vocabulary vocabulary = hallway(3).vocabulary();
  const ltl::VerbaliseOptions english{.describe = hallway_english(vocabulary)};
  for (const Row& row : table) {
    ltl::Arena arena(vocabulary);
    const ltl::Formula f = ltl::parse(row.formula, arena);
    const std::string text = ltl::verbalise(f, english);
    EXPECT_EQ(text, row.english);
    EXPECT_EQ(ltl::read_english(text, arena, english), f) << text;
  }
}

}  // namespace
}  // namespace waymark::plan
