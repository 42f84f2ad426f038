#include "libltl/meaning/trace_check.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

Trace suffix(const Trace& word, std::size_t i) {
  return Trace(std::vector<Letter>(word.begin() + static_cast<std::ptrdiff_t>(i), word.end()));
}

TEST(Columns, TheLastPositionIsBitZero) {
  const Proposition a{0}, b{1};
  const Columns columns(Trace({Letter{a}, Letter{a, b}, Letter{}}), 2);
  EXPECT_EQ(columns.length(), 3U);
  EXPECT_EQ(columns.block(0)[0], 0b110U);
  EXPECT_EQ(columns.block(0)[1], 0b010U);
}

TEST(Columns, AppendingLettersIsTheSameAsReadingTheWord) {
  Random random(3);
  Columns grown(70);
  for (std::size_t length : {1U, 63U, 64U, 65U, 130U, 200U}) {
    const Trace word = random_trace(random, {.length = length, .atoms = 70});
    grown.clear();
    for (const Letter& letter : word) grown.append(letter);
    const Columns whole(word, 70);
    ASSERT_EQ(grown.blocks(), whole.blocks());
    for (std::size_t block = 0; block < whole.blocks(); ++block)
      for (std::size_t p = 0; p < 70; ++p)
        EXPECT_EQ(grown.block(block)[p], whole.block(block)[p]) << length << ' ' << p;
  }
}

TEST(Laws, TraceCheckAgreesWithTheDefinition) {
  Arena arena(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 4, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    TraceCheck check(f);
    for (const Trace& word : words) ASSERT_EQ(check(Columns(word, 2)), holds(word, f)) << show(f, word);
  });
}

// Lengths around the borders of blocks, every position, both entry points.
TEST(Laws, TraceCheckAgreesWithTheDefinitionAtEveryPositionOfLongWords) {
  Arena arena(testing::letters_vocabulary(3));
  Random random(4);
  for (int i = 0; i < 150; ++i) {
    const Formula f = random_formula(random, arena, {.size = 14, .atoms = 3});
    const std::size_t length = 60 + random.below(80);
    const Trace word = random_trace(random, {.length = length, .atoms = 3, .density = i % 2 == 0 ? 0.5 : 0.97});
    const Columns columns(word, 3);
    TraceCheck check(f);
    ASSERT_EQ(check(columns), holds(word, f)) << show(f, word) << "   seed 4, pair " << i;
    std::vector<std::uint64_t> truth(columns.blocks());
    check.at_every_position(columns, 0, truth);
    for (std::size_t k = 0; k < length; k += 11) {
      const std::size_t bit = length - 1 - k;
      ASSERT_EQ(((truth[bit / 64] >> (bit % 64)) & 1U) != 0, holds(suffix(word, k), f)) << show(f, suffix(word, k));
    }
    if (length <= 64) {
      ASSERT_EQ(check(columns.block(0), length), holds(word, f)) << show(f, word);
    }
  }
}

TEST(TraceCheck, SharesWhatItsFormulasShare) {
  Arena arena;
  const Formula shared = parse("F(a & X b)", arena), other = parse("G !c", arena);
  const std::array<Formula, 3> formulas{shared, conjunction(shared, other), other};
  TraceCheck together(formulas);
  EXPECT_EQ(together.steps(), TraceCheck(formulas[1]).steps());
  Columns word(3);
  word.append(Letter{Proposition{0}});
  word.append(Letter{Proposition{1}, Proposition{2}});
  std::array<bool, 3> verdicts{};
  together.check(word, verdicts);
  EXPECT_EQ(verdicts, (std::array<bool, 3>{true, false, false}));
}

// Several formulas at once, words on both sides of a block of 64 positions.
TEST(TraceCheck, TellsEveryFormulaOfLongWords) {
  Arena arena(testing::letters_vocabulary(2));
  Random random(19);
  std::vector<Formula> formulas;
  for (int i = 0; i < 40; ++i) formulas.push_back(random_formula(random, arena, {.size = 9, .atoms = 2}));
  TraceCheck together(formulas);
  std::vector<std::size_t> lengths;
  for (std::size_t n = 1; n <= 8; ++n) lengths.push_back(n);
  for (const std::size_t n : {62U, 63U, 64U, 65U, 66U, 67U, 127U, 128U, 129U, 130U}) lengths.push_back(n);
  const auto verdicts = std::make_unique<bool[]>(formulas.size());
  for (const std::size_t length : lengths)
    for (int trial = 0; trial < 5; ++trial) {
      std::vector<Letter> letters(length);
      for (Letter& letter : letters)
        for (const Proposition p : {Proposition{0}, Proposition{1}})
          if (random.chance(0.5)) letter.insert(p);
      const Trace word(letters);
      together.check(Columns(word, 2), std::span(verdicts.get(), formulas.size()));
      for (std::size_t i = 0; i < formulas.size(); ++i)
        ASSERT_EQ(verdicts[i], holds(word, formulas[i])) << show(formulas[i], word);
    }
}

TEST(TraceCheck, RefusesWhatItCannotRead) {
  Arena arena;
  TraceCheck check(parse("a & b", arena));
  EXPECT_THROW(check(Columns(2)), std::invalid_argument);  // no letter
  EXPECT_THROW(check(Columns(Trace({Letter{}}), 1)), std::invalid_argument);
  const std::array<std::uint64_t, 2> columns{1, 1};
  EXPECT_TRUE(check(columns, 1));
  EXPECT_THROW(check(columns, 65), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::ltl
