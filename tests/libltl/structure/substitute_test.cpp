// Substitution against the definition: a formula with images says of a word what the formula says of the word whose
// letters tell where the images hold.
#include "libltl/structure/substitute.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

constexpr Proposition a{0}, b{1};

// ¬b for a, a ∧ b for b.
Letter images_of(const Letter& letter) {
  Letter out;
  if (!letter.contains(b)) out.insert(a);
  if (letter.contains(a) && letter.contains(b)) out.insert(b);
  return out;
}

TEST(Substitute, SaysOfAWordWhatTheFormulaSaysOfItsImages) {
  Arena from(testing::letters_vocabulary(2)), to(testing::letters_vocabulary(2));
  const Formula not_b = negate(to.atom(b)), both = conjunction(to.atom(a), to.atom(b));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  std::vector<Trace> images;
  for (const Trace& word : words) {
    std::vector<Letter> letters;
    for (const Letter& letter : word) letters.push_back(images_of(letter));
    images.emplace_back(std::move(letters));
  }
  testing::for_each_formula(from, {.size = 4, .atoms = 2, .past = true}, [&](Formula f) {
    const Formula g = substitute(f, to, [&](Proposition p) { return p == a ? not_b : both; });
    for (std::size_t i = 0; i < words.size(); ++i)
      ASSERT_EQ(holds(words[i], g), holds(images[i], f)) << print(f) << " became " << show(g, words[i]);
  });
}

TEST(Substitute, ByItselfChangesNothing) {
  Arena from(testing::letters_vocabulary(2)), to(testing::letters_vocabulary(2));
  testing::for_each_formula(from, {.size = 4, .atoms = 2, .past = true}, [&](Formula f) {
    ASSERT_EQ(print(substitute(f, to, [&](Proposition p) { return to.atom(p); })), print(f));
    ASSERT_EQ(substitute(f, from, [&](Proposition p) { return from.atom(p); }), f) << print(f);
  });
}

// One operator over other operands, for each operator.
TEST(WithOperands, KeepsTheOperatorAndTheOrder) {
  Arena arena(testing::letters_vocabulary(4));
  const std::vector<Formula> others{arena.atom(Proposition{2}), arena.atom(Proposition{3})};
  for (const auto& [before, after] : std::vector<std::pair<const char*, const char*>>{{"!a", "!c"},
                                                                                      {"a & b", "c & d"},
                                                                                      {"a | b", "c | d"},
                                                                                      {"a <-> b", "c <-> d"},
                                                                                      {"X a", "X c"},
                                                                                      {"N a", "N c"},
                                                                                      {"a U b", "c U d"},
                                                                                      {"a R b", "c R d"},
                                                                                      {"Y a", "Y c"},
                                                                                      {"a S b", "c S d"}}) {
    const Formula f = parse(before, arena);
    EXPECT_EQ(with_operands(f, arena, std::span(others).first(f.operands().size())), parse(after, arena)) << before;
  }
}

}  // namespace
}  // namespace waymark::ltl
