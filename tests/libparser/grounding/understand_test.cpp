#include "libparser/grounding/understand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "libltl/english/verbalise.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libparser/grounding/direct_turns.hpp"
#include "libparser/language/synchronous_grammar.hpp"
#include "libparser/model_file.hpp"
#include "libplan/world/observable_english.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/generate.hpp"

namespace waymark::parser {
namespace {

const std::filesystem::path source = WAYMARK_SOURCE_DIR;

const Grounder& shipped() {
  static const Grounder grounder = load_grounder(source / "data" / "models" / "encoder-decoder.waymark");
  return grounder;
}

Understanding understood(const std::string& text, ltl::Arena& arena) {
  const plan::Map& map = shipped_maps()[2];
  static const Executor executor(map);
  return understand(shipped(), text, executor, std::vector{plan::PoseId{0}}, arena);
}

Understanding understood(const std::string& text) {
  ltl::Arena arena(shipped_maps()[2].vocabulary());
  return understood(text, arena);
}

// Chatter, other domains, other languages, places that no map has: written by hand, none of them trained on.
TEST(Understand, RefusesWhatIsNoInstruction) {
  std::ifstream file(source / "tests" / "libparser" / "data" / "no_instructions.txt");
  std::size_t texts = 0, refused = 0;
  for (std::string text; std::getline(file, text); ++texts) {
    const Understanding answer = understood(text);
    refused += answer.readings.empty() ? 1 : 0;
    if (!answer.readings.empty()) std::printf("  understood: %s\n", text.c_str());
  }
  EXPECT_EQ(texts, 200U);
  EXPECT_GE(refused, 190U);
}

// A map whose names no text of the training said.
TEST(Understand, ReadsRouteInstructionsOnOtherMaps) {
  const plan::Map map("home", {{0, 0, "kitchen", {}}, {1, 0, "meeting room", {}}, {2, 0, "desk", {}}, {1, 1, {}, {}}},
                      {{0, 1, "tiles", ""}, {1, 2, "carpet", ""}, {1, 3, "carpet", ""}},
                      {"kitchen", "meeting room", "desk"}, {"tiles", "carpet"}, {});
  const Executor executor(map);
  const auto first = [&](const std::string& text) {
    ltl::Arena arena(map.vocabulary());
    const Understanding answer = understand(shipped(), text, executor, std::vector{plan::PoseId{1}}, arena);
    return answer.readings.empty() ? std::string("nothing") : ltl::print(answer.readings.front().formula);
  };
  EXPECT_EQ(first("turn left"), "X turned_left");
  EXPECT_EQ(first("walk to the desk"), "F desk");
  EXPECT_EQ(first("never step on the carpet"), "G !carpet");
  EXPECT_EQ(first("go to the kitchen, then to the meeting room"), "F(kitchen & F \"meeting room\")");
  EXPECT_EQ(first("turn right and walk to the kitchen"), "X(turned_right & F kitchen)");
}

TEST(Understand, SaysWhichNameIsMissing) {
  const Understanding machine = understood("go to the coffee machine");
  ASSERT_TRUE(machine.missing);
  EXPECT_EQ(machine.missing->words, "coffee machine");
  const Understanding typo = understood("go to the cofa");
  ASSERT_TRUE(typo.missing);
  EXPECT_EQ(typo.missing->words, "cofa");
  ASSERT_FALSE(typo.missing->nearest.empty());
  EXPECT_EQ(typo.missing->nearest.front(), "sofa");
  EXPECT_FALSE(understood("xyzzy plugh").missing);
}

// What is said of one side is said of the other, for every text of our own grammar.
TEST(Understand, LeftAndRightAreReadAlike) {
  const SynchronousGrammar grammar(source / "data" / "language" / "commands.grammar");
  const LiftedReader& reader = *shipped().commands;
  ltl::Random random(7);
  std::size_t sided = 0;
  for (int i = 0; i < 400; ++i) {
    const auto said = grammar.say("COMMAND", random);
    const LiftedText text{said.tokens, {said.slots, 0, true}, ""};
    if (mirrored(text).tokens == text.tokens) continue;
    ++sided;
    const auto here = reader.read(text), there = reader.read(mirrored(text));
    ASSERT_EQ(here.size(), there.size());
    EXPECT_EQ(mirrored(here.front().lifted), there.front().lifted);
    EXPECT_EQ(here.front().log_probability, there.front().log_probability);
  }
  EXPECT_GT(sided, 20U);
}

// Texts that the training did not draw: another seed. People's words decide, and our own language is the smaller voice.
TEST(Understand, ReadsItsOwnLanguage) {
  const SynchronousGrammar grammar(source / "data" / "language" / "commands.grammar");
  ltl::Random random(987'654'321);
  int right = 0, texts = 300;
  for (int i = 0; i < texts; ++i) {
    const auto said = grammar.say("COMMAND", random);
    const auto readings = shipped().commands->read({said.tokens, {said.slots, 0, true}, ""});
    right += canonical(readings.front().lifted) == canonical(said.lifted) ? 1 : 0;
  }
  EXPECT_GE(right, 80 * texts / 100) << right;
}

// A sentence of waymark is read as it is, even where no route can fulfil it and a likelier text would have one.
TEST(Understand, ReadsWhatWaymarkSaysAsItIs) {
  ltl::Arena arena(shipped_maps()[2].vocabulary());
  for (const char* text : {"X behind_grass", "G !ahead_easel", "sofa & !blue", "X X dead_end", "F(grass & X !grass)"}) {
    const ltl::Formula meant = ltl::parse(text, arena, {.unknown = ltl::Unknown::Reject});
    const std::string said = ltl::verbalise(meant, {ltl::Semantics::Finite, plan::hallway_english(arena.vocabulary())});
    const Understanding answer = understood(said, arena);
    ASSERT_FALSE(answer.readings.empty()) << said;
    EXPECT_EQ(answer.readings.front().formula, meant)
        << said << " was read as " << ltl::print(answer.readings.front().formula);
  }
}

TEST(Understand, StraightToTheThirdHallway) {
  ltl::Arena arena(shipped_maps()[2].vocabulary());
  const Understanding answer = understood("go down the third corridor to your left", arena);
  ASSERT_FALSE(answer.readings.empty());
  const ltl::Formula way = arena.atom(*arena.vocabulary().find("left_open"));
  const ltl::Formula moved = arena.atom(*arena.vocabulary().find("moved"));
  const ltl::Formula turned = arena.atom(*arena.vocabulary().find("turned_left"));
  ltl::Formula rest = ltl::next(ltl::conjunction(turned, ltl::next(moved)));
  for (int i = 0; i < 3; ++i)
    rest = ltl::next(
        ltl::until(ltl::conjunction(moved, ltl::negate(way)), ltl::conjunction(ltl::conjunction(moved, way), rest)));
  EXPECT_EQ(answer.readings.front().formula, rest);
}

// By the definition on all short words: what is made direct implies what the program says.
TEST(DirectTurns, AreStrongerThanWhatTheProgramSays) {
  ltl::Arena arena(ltl::Vocabulary({"turned_left", "turned_right", "a"}));
  for (const char* text :
       {"X((turned_left | turned_right) U ((turned_left | turned_right) & turned_left))",
        "X((turned_left | turned_right) U ((turned_left | turned_right) & turned_right & F a))",
        "F(a & X((turned_left | turned_right) U ((turned_left | turned_right) & turned_left & X a)))"}) {
    const ltl::Formula open = ltl::parse(text, arena), direct = with_direct_turns(open);
    EXPECT_NE(open, direct);
    std::size_t satisfied = 0;
    for (const ltl::Trace& word : testing::all_traces({.length = 4, .atoms = 3})) {
      if (!ltl::holds(word, direct)) continue;
      ++satisfied;
      EXPECT_TRUE(ltl::holds(word, open)) << text;
    }
    EXPECT_GT(satisfied, 0U);
  }
  const ltl::Formula facing = ltl::parse("X((turned_left | turned_right) U ((turned_left | turned_right) & a))", arena);
  EXPECT_EQ(with_direct_turns(facing), facing);
}

}  // namespace
}  // namespace waymark::parser
