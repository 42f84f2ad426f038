// The pattern catalogues: against the formulas as collected elsewhere, and against words that show what they mean.
#include "libltl/patterns/patterns.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/places.hpp"

namespace waymark::ltl {
namespace {

namespace fs = std::filesystem;

// By odd number of the catalogue: which parameter p0, p1, … of the collected formula is.
constexpr const char* parameters_of_line[] = {"p",    "qp",    "qrp",  "rp",    "qrp",  "p",     "qp",
                                              "qpr",  "rp",    "qrp",  "ps",    "qps",  "qrps",  "rps",
                                              "qrps", "pst",   "qpst", "qprst", "rstp", "qrstp", "stp",
                                              "qstp", "qsrtp", "rpst", "qrpst", "pszt", "qpszt", "qprszt"};

TEST(Patterns, AgreeWithTheCollectedFormulas) {
  const fs::path file = testing::shared() / "ltl" / "ltl_dwyer.ltl";
  if (!fs::exists(file)) GTEST_SKIP() << "benchmark formulas not found: " << file << " (set WAYMARK_SHARED)";
  std::ifstream in(file);
  const std::vector<Pattern> patterns = property_patterns();
  std::size_t line = 0;
  for (std::string text; std::getline(in, text); ++line) {
    ASSERT_LT(line, std::size(parameters_of_line));
    const Pattern& pattern = patterns[2 * line];
    Arena arena;
    const std::string order = parameters_of_line[line];
    std::vector<std::string> arguments;
    for (char parameter : pattern.parameters)
      if (parameter != ' ') arguments.push_back("p" + std::to_string(order.find(parameter)));
    for (std::size_t i = 0; i < order.size(); ++i) arena.atom("p" + std::to_string(i));
    const Formula ours = instantiate(pattern.name, arguments, arena), theirs = parse(text, arena);
    if (ours == theirs) continue;
    Random random(line + 1);
    for (int i = 0; i < 2'000; ++i) {
      const Lasso word = random_lasso(
          random, {.prefix = random.below(6), .cycle = 1 + random.below(4), .atoms = order.size(), .density = 0.3});
      ASSERT_EQ(holds(word, ours), holds(word, theirs))
          << pattern.name << " " << print(ours) << " and line " << line + 1 << " " << print(theirs) << " on "
          << show(word, arena.vocabulary());
    }
  }
  EXPECT_EQ(line, std::size(parameters_of_line));
}

TEST(Patterns, HaveNamesOfTheirOwnAndFormulasThatInstantiateThem) {
  std::set<std::string> names;
  std::vector<Pattern> all = property_patterns();
  EXPECT_EQ(all.size(), 55U);
  for (const Pattern& mission : mission_patterns()) all.push_back(mission);
  EXPECT_EQ(all.size(), 77U) << "the missions of [MTP+21] are 22";
  for (const Pattern& pattern : all) {
    EXPECT_TRUE(names.insert(pattern.name).second) << pattern.name;
    EXPECT_TRUE(pattern.source == "DAC98" || pattern.source == "MTP+21");
    std::vector<std::string> arguments;
    for (char parameter : pattern.parameters)
      if (parameter != ' ') arguments.emplace_back(1, parameter);
    if (pattern.parameters == "l..") arguments = {"l1", "l2", "l3"};
    if (pattern.parameters == "n l") arguments = {"2", "l"};
    Arena arena;
    EXPECT_EQ(print(parse(pattern.formula, arena)), print(instantiate(pattern.name, arguments, arena))) << pattern.name;
  }
}

// Before the first r, every scope "before" is the body on the word up to there; likewise for the others: told apart
// by words on which absence holds in one scope and not in the next.
TEST(Patterns, ScopesAreWhatTheySay) {
  const auto absent = [](Scope scope, std::initializer_list<const char*> letters) {
    Arena arena(Vocabulary({"p", "q", "r"}));
    std::vector<Letter> word;
    for (std::string_view text : letters) {
      word.emplace_back();
      for (char c : text) word.back().insert(*arena.vocabulary().find(std::string(1, c)));
    }
    std::vector<Formula> arguments{arena.atom("p")};
    if (scope == Scope::After || scope == Scope::Between || scope == Scope::AfterUntil)
      arguments.push_back(arena.atom("q"));
    if (scope == Scope::Before || scope == Scope::Between || scope == Scope::AfterUntil)
      arguments.push_back(arena.atom("r"));
    return holds(Lasso(word, {Letter{}}), property(Body::Absence, scope, arguments));
  };
  EXPECT_FALSE(absent(Scope::Globally, {"", "p"}));
  EXPECT_TRUE(absent(Scope::Before, {"", "r", "p"}));
  EXPECT_FALSE(absent(Scope::Before, {"p", "r"}));
  EXPECT_TRUE(absent(Scope::Before, {"p", "p"})) << "there is no r";
  EXPECT_TRUE(absent(Scope::After, {"p", "q"}));
  EXPECT_FALSE(absent(Scope::After, {"q", "", "p"}));
  EXPECT_TRUE(absent(Scope::Between, {"q", "p"})) << "there is no r";
  EXPECT_FALSE(absent(Scope::Between, {"q", "p", "r"}));
  EXPECT_FALSE(absent(Scope::AfterUntil, {"q", "p"}));
  EXPECT_TRUE(absent(Scope::AfterUntil, {"q", "r", "p"}));
}

TEST(Patterns, UnknownNamesBringNearOnesToMind) {
  const auto message = [](std::string_view name) -> std::string {
    Arena arena;
    try {
      instantiate(name, std::vector<std::string>{"a"}, arena);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  const struct {
    const char *name, *meant;
  } table[] = {{"visits", "visit"},
               {"wayt", "wait"},
               {"absence", "absence-globally"},
               {"absense", "absence-globally"},
               {"absence-befor", "absence-before"}};
  for (const auto& row : table)
    EXPECT_NE(message(row.name).find(std::string("(did you mean '") + row.meant + "'?)"), std::string::npos)
        << message(row.name);
  EXPECT_EQ(message("qqqqqqqqqqqq"), "there is no pattern 'qqqqqqqqqqqq'");
}

TEST(Patterns, RefuseWhatDoesNotFit) {
  Arena arena;
  const auto make = [&](std::string_view name, std::vector<std::string> arguments) {
    return instantiate(name, arguments, arena);
  };
  EXPECT_THROW(make("absence-sometimes", {"p"}), std::invalid_argument);
  EXPECT_THROW(make("absence-before", {"p"}), std::invalid_argument);
  EXPECT_THROW(make("visit", {}), std::invalid_argument);
  EXPECT_THROW(make("wait", {"a"}), std::invalid_argument);
  const auto message = [&](std::string_view name, std::vector<std::string> arguments) -> std::string {
    try {
      make(name, std::move(arguments));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("visit", {}), "visit takes one or more arguments (l..), not 0");
  EXPECT_EQ(message("wait", {"a"}), "wait takes 2 arguments (l p), not 1");
  EXPECT_EQ(message("exact-restricted-avoidance", {"a"}), "exact-restricted-avoidance takes a number and a place");
  EXPECT_THROW(make("upper-restricted-avoidance", {"0", "a"}), std::invalid_argument);
  EXPECT_THROW(make("upper-restricted-avoidance", {"2x", "a"}), std::invalid_argument);
  EXPECT_EQ(make("lower-restricted-avoidance", {"1", "a"}), parse("F a", arena));
  EXPECT_THROW(make("visit", {"a", "b U"}), SyntaxError);
  EXPECT_EQ(print(make("response-globally", {"a & b", "F c"})), "G((a & b) -> F F c)");
}

}  // namespace
}  // namespace waymark::ltl
