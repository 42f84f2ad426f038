#include "libltl/text/print.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::for_each_formula;
using testing::letters_vocabulary;

struct Row {
  const char *text, *ascii, *unicode, *latex, *lbt, *postfix;
};

TEST(Print, AnImplicationIsPrintedAsItWasTyped) {
  for (const char* text : {"moving -> !door", "!door | !moving", "G(a -> !b)", "a -> (!b | !c)", "a -> b",
                           "(a & b) -> !c", "!a | !b | !c", "G(a -> X !b)"}) {
    Arena arena;
    const std::string once = print(parse(text, arena));
    Arena again;
    EXPECT_EQ(print(parse(once, again)), once) << text;
    EXPECT_EQ(once, text);
  }
}

TEST(Print, WritesEveryStyle) {
  const Row table[] = {
      {"F(chair & X(turned_left & F sofa))", "F(chair & X(turned_left & F sofa))", "◇(chair ∧ ○(turned_left ∧ ◇sofa))",
       "\\mathsf{F}\\,(\\mathit{chair} \\land \\mathsf{X}\\,(\\mathit{turned\\_left} \\land "
       "\\mathsf{F}\\,\\mathit{sofa}))",
       "F & chair X & turned_left F sofa", "chair turned_left sofa F & X & F"},
      {"!(a U b) | N c", "(a U b) -> N c", "(a 𝒰 b) → ●c",
       "(\\mathit{a} \\mathbin{\\mathsf{U}} \\mathit{b}) \\rightarrow \\mathsf{N}\\,\\mathit{c}", "i U a b N c",
       "a b U c N ->"},
      {"a xor true R false", "a ^ (true R false)", "a ⊕ (⊤ ℛ ⊥)",
       "\\mathit{a} \\oplus (\\top \\mathbin{\\mathsf{R}} \\bot)", "^ a V t f", "a true false R ^"},
      {"a & b & c", "a & b & c", "a ∧ b ∧ c", "\\mathit{a} \\land \\mathit{b} \\land \\mathit{c}", "& & a b c",
       "a b & c &"},
      {"F<=2 a", "F<=2 a", "◇≤2 a", "\\mathsf{F}_{\\leq 2}\\,\\mathit{a}", "| a X | a X a", "a a a X | X |"},
      {"\"e\" W \"a b\"", "e W \"a b\"", "e 𝒲 \"a b\"", "\\mathit{e} \\mathbin{\\mathsf{W}} \\mathit{a\\ b}",
       "W \"e\" \"a b\"", "e \"a b\" W"},
  };
  for (const Row& row : table) {
    Arena arena;
    const Formula f = parse(row.text, arena);
    EXPECT_EQ(print(f, Style::Ascii), row.ascii);
    EXPECT_EQ(print(f, Style::Latex), row.latex);
    EXPECT_EQ(print(f, Style::Unicode), row.unicode);
    EXPECT_EQ(print(f, Style::Lbt), row.lbt);
    EXPECT_EQ(print(f, Style::Postfix), row.postfix);
  }
}

struct Pair {
  const char *text, *printed;
};

TEST(Print, AsciiHasTheParenthesesAReaderNeeds) {
  const Pair table[] = {
      {"(((a)))", "a"},
      {"!a U b", "!a U b"},
      {"F a U b", "(F a) U b"},
      {"!(a & b)", "!(a & b)"},
      {"! F a", "!F a"},
      {"G F a", "G F a"},
      {"G(a -> F b)", "G(a -> F b)"},
      {"(a & b) | c", "(a & b) | c"},
      {"(a | b) -> c", "(a | b) -> c"},
      {"a U (b U c)", "a U (b U c)"},
      {"F<=3 (a & b)", "F<=3 (a & b)"},
      {"a | X a", "a | X a"},
      {"a | X(a | X(a | b))", "a | X(a | X(a | b))"},
      {"F<=2 (a | b)", "F<=2 (a | b)"},
      {"G<=2 N a", "G<=2 N a"},
      {"F<=2 F<=3 a", "F<=2 F<=3 a"},
      {"F[2:5] a", "F[2:5] a"},
      {"X X F<=3 a", "F[2:5] a"},
      {"N G<=2 (a | b)", "G[1:3] (a | b)"},
      {"X G<=2 a", "X G<=2 a"},
      {"X[2] N F<=2 a", "X X N F<=2 a"},
      {"F[2:3] a", "X X(a | X a)"},
      {"F[3:3] a", "X X X a"},
      {"G(a -> F[2,5](b & F[0,10] c))", "G(a -> F[2:5] (b & F<=10 c))"},
      {"X(a & X F<=2 b)", "X(a & F[1:3] b)"},
      {"F[1:3] F[2:6] a | b", "F[1:3] F[2:6] a | b"},
      {"a R a", "a R a"},
      {"(a | b | c) W b", "(a | c) W b"},
      {"(b | c) R (a | b | c)", "a W (b | c)"},
      {"(a & b) M c", "(a & b) M c"},
      {"a R (a & b)", "a R (a & b)"},
      {"\"X\" & \"GF\" & \"true\" & \"x y\" & \"i\"", "\"X\" & \"GF\" & \"true\" & \"x y\" & i"},
  };
  for (const Pair& pair : table) {
    Arena arena;
    EXPECT_EQ(print(parse(pair.text, arena)), pair.printed);
  }
}

TEST(Print, NamesAreQuotedWhereTheyMustBe) {
  EXPECT_EQ(print_name("place_3"), "place_3");
  EXPECT_EQ(print_name("3rd"), "\"3rd\"");
  EXPECT_EQ(print_name("M"), "\"M\"");
  EXPECT_EQ(print_name("a\nb\\\""), "\"a\\nb\\\\\\\"\"");
  EXPECT_EQ(print_name("i"), "i");
  EXPECT_EQ(print_name("i", Style::Lbt), "\"i\"");
  EXPECT_EQ(print_name("50%_off", Style::Latex), "\\mathit{50\\%\\_off}");
}

void expect_round_trips(Formula f) {
  const struct {
    Style style;
    Notation notation;
  } forms[] = {{Style::Ascii, Notation::Infix},
               {Style::Unicode, Notation::Infix},
               {Style::Lbt, Notation::Lbt},
               {Style::Postfix, Notation::Postfix}};
  for (const auto& form : forms) {
    const std::string text = print(f, form.style);
    const Formula again = parse(text, f.arena(), {.notation = form.notation});
    ASSERT_EQ(again, f) << text << " was read as " << print(again);
  }
}

TEST(Laws, ParseInvertsPrintOnEverySmallFormula) {
  Arena arena(letters_vocabulary(2));
  for_each_formula(arena, {.size = 5, .atoms = 2}, expect_round_trips);
}

// Bounds behind nexts, of both kinds, of all small formulas.
TEST(Laws, ParseInvertsPrintOfDelayedBounds) {
  Arena arena(letters_vocabulary(2));
  for_each_formula(arena, {.size = 3, .atoms = 2}, [](Formula body) {
    for (std::size_t k = 0; k <= 3; ++k)
      for (const Formula bound : {eventually_within(k, body), always_within(k, body)})
        for (std::size_t nexts = 0; nexts < 8; ++nexts) {
          Formula f = bound;
          for (std::size_t i = 0; i < 3; ++i) f = (nexts >> i & 1U) != 0 ? next(f) : weak_next(f);
          expect_round_trips(f);
          expect_round_trips(conjunction(f, body));
          expect_round_trips(disjunction(next(bound), weak_next(bound)));
        }
  });
}

TEST(Laws, ParseInvertsPrintOnRandomFormulas) {
  Arena arena(Vocabulary({"a", "b", "red chair", "X", "i"}));
  Random random(1);
  for (int i = 0; i < 2'000; ++i) expect_round_trips(random_formula(random, arena, {.size = 30, .atoms = 5}));
}

TEST(Print, DeepFormulasDoNotOverflow) {
  Arena arena;
  Formula f = arena.atom("a");
  for (std::size_t i = 1; i < most_levels; ++i) f = i % 2 == 0 ? until(arena.atom("b"), f) : next(f);
  expect_round_trips(f);
}

}  // namespace
}  // namespace waymark::ltl
