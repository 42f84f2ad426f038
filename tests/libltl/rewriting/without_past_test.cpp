#include "libltl/rewriting/without_past.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

TEST(WithoutPast, KnowsHistoriesThatLettersDetermine) {
  const struct {
    const char* formula;
    bool determined;
  } table[] = {
      {"a", true},          {"F a", true},          {"a & Y b", true},    {"F (a S b)", true},
      {"Y a U O b", true},  {"Y X a", false},       {"O F a", false},     {"b & O F a", false},
      {"O F a & b", false}, {"F (a S X b)", false}, {"b U Y F a", false}, {"H (a | Y (b U a))", false},
  };
  for (const auto& row : table) {
    Arena from(Vocabulary({"a", "b"})), to(Vocabulary({"a", "b"}));
    const WithoutPast found = without_past(parse(row.formula, from), to);
    EXPECT_EQ(found.determined, row.determined) << row.formula;
    EXPECT_FALSE(has_past(found.formula)) << row.formula;
    EXPECT_EQ(to.vocabulary().size() > 2, has_past(parse(row.formula, from))) << row.formula;
  }
}

Trace with_histories(const Trace& word, std::size_t atoms, std::size_t histories, std::uint32_t bits) {
  std::vector<Letter> letters;
  for (std::size_t i = 0; i < word.size(); ++i) {
    Letter letter = word[i];
    for (std::size_t h = 0; h < histories; ++h)
      if ((bits >> (i * histories + h) & 1U) != 0) letter.insert({static_cast<std::uint32_t>(atoms + h)});
    letters.push_back(letter);
  }
  return Trace(letters);
}

// A word with φ has exactly one choice of histories, a word without φ none. Of φ and of ¬φ, so every word has one.
TEST(WithoutPast, AWordHasOneChoiceOfHistoriesWhereTheFormulaHolds) {
  Arena from(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  std::size_t tried = 0;
  testing::for_each_formula(from, {.size = 4, .atoms = 2, .past = true}, [&](Formula f) {
    if (!has_past(f)) return;
    ++tried;
    for (const Formula g : {f, negate(f)}) {
      Arena to(testing::letters_vocabulary(2));
      const WithoutPast found = without_past(g, to);
      const std::size_t histories = to.vocabulary().size() - 2;
      for (const Trace& word : words) {
        int choices = 0;
        for (std::uint32_t bits = 0; bits < 1U << (word.size() * histories); ++bits)
          choices += holds(with_histories(word, 2, histories, bits), found.formula) ? 1 : 0;
        ASSERT_EQ(choices, holds(word, g) ? 1 : 0) << testing::show(g, word) << " as " << print(found.formula);
      }
    }
  });
  EXPECT_GT(tried, 300U);
}

// The same on lassos u·vʷ with one past operator: its history is that of u·v·vʷ.
TEST(WithoutPast, ALassoHasOneChoiceOfHistoriesWhereTheFormulaHolds) {
  for (const char* text : {"Y a", "a S b", "b S a", "O a", "H a", "F Y a", "G F (a S b)", "F G O a", "(a S b) U Y a",
                           "Y X a", "G (b -> H a)", "a S X b", "N Y a", "b R (a S b)"}) {
    Arena from(testing::letters_vocabulary(2));
    const Formula positive = parse(text, from);
    for (const Formula f : {positive, negate(positive)}) {
      Arena to(testing::letters_vocabulary(2));
      const WithoutPast found = without_past(f, to);
      const std::size_t histories = to.vocabulary().size() - 2;
      if (histories > 2) continue;
      testing::for_each_lasso({.length = 2, .atoms = 2}, [&](const Lasso& word) {
        std::vector<Letter> letters;
        for (std::size_t i = 0; i < word.size(); ++i) letters.push_back(word[i]);
        for (std::size_t i = word.loop_start(); i < word.size(); ++i) letters.push_back(word[i]);
        int choices = 0;
        for (std::uint32_t bits = 0; bits < 1U << (letters.size() * histories); ++bits) {
          const Trace both = with_histories(Trace(letters), 2, histories, bits);
          std::vector<Letter> prefix, cycle;
          for (std::size_t i = 0; i < both.size(); ++i) (i < word.size() ? prefix : cycle).push_back(both[i]);
          choices += holds(Lasso(prefix, cycle), found.formula) ? 1 : 0;
        }
        EXPECT_EQ(choices, holds(word, f) ? 1 : 0) << testing::show(f, word);
      });
    }
  }
}

TEST(WithoutPast, HistoriesHaveNamesThatNobodyHas) {
  Arena from(Vocabulary({"history 2", "a"})), to(Vocabulary({"history 2", "a"}));
  without_past(parse("Y a & O \"history 2\"", from), to);
  ASSERT_EQ(to.vocabulary().size(), 4U);
  EXPECT_EQ(to.vocabulary().name(Proposition{2}), "history 2'");
  EXPECT_EQ(to.vocabulary().name(Proposition{3}), "history 3");
}

// A trimmed deterministic automaton stays deterministic: the letters read so far leave one choice of histories.
TEST(WithoutPast, DeterminedHistoriesAreKnownFromTheLettersSoFar) {
  Arena from(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  std::size_t determined = 0, open = 0;
  testing::for_each_formula(from, {.size = 4, .atoms = 2, .past = true}, [&](Formula f) {
    if (!has_past(f)) return;
    Arena to(testing::letters_vocabulary(2));
    const WithoutPast found = without_past(f, to);
    const std::size_t histories = to.vocabulary().size() - 2;
    std::map<std::string, std::set<std::uint32_t>> of_prefix;  // the histories of its letters
    for (const Trace& word : words)
      for (std::uint32_t bits = 0; bits < 1U << (word.size() * histories); ++bits) {
        if (!holds(with_histories(word, 2, histories, bits), found.formula)) continue;
        std::vector<Letter> letters;
        for (std::size_t i = 0; i < word.size(); ++i) {
          letters.push_back(word[i]);
          of_prefix[show(Trace(letters), from.vocabulary())].insert(bits & ((1U << (letters.size() * histories)) - 1U));
        }
      }
    const bool one_each =
        std::all_of(of_prefix.begin(), of_prefix.end(), [](const auto& p) { return p.second.size() == 1; });
    EXPECT_TRUE(one_each || !found.determined) << testing::show(f);
    ++(found.determined ? determined : open);
  });
  EXPECT_GT(determined, 100U);
  EXPECT_GT(open, 10U);
}

}  // namespace
}  // namespace waymark::ltl
