#include "libparser/lifted/lifted_formula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libparser/lifted/templates.hpp"
#include "tests/support/generate.hpp"

namespace waymark::parser {
namespace {

using enum LiftedSymbol;

// Slot n is the n-th name; events are propositions of their names; directions of slots do not exist.
struct Letters {
  explicit Letters(std::vector<std::string> of) : names(std::move(of)), arena(ltl::Vocabulary(vocabulary(names))) {
    bindings.arena = &arena;
    bindings.literal = [this](LiftedSymbol direction, LiftedSymbol thing) -> std::optional<ltl::Formula> {
      if (direction != End || is_constant(thing)) return std::nullopt;
      if (!is_slot(thing)) return arena.atom(*arena.vocabulary().find(name(thing)));
      if (number_of(thing) > names.size()) return std::nullopt;
      return arena.atom(*arena.vocabulary().find(names[number_of(thing) - 1]));
    };
  }
  static std::vector<std::string> vocabulary(std::vector<std::string> names) {
    for (const LiftedSymbol s : {TurnedLeft, TurnedRight, Moved, Start, OpenLeft, OpenRight}) names.push_back(name(s));
    return names;
  }
  std::optional<Lifted> spell(ltl::Formula f) const {
    return parser::spell(f, [&](ltl::Proposition p) -> std::optional<Lifted> {
      const auto at = std::find(names.begin(), names.end(), arena.vocabulary().name(p));
      if (at == names.end()) return std::nullopt;
      return Lifted{slot(static_cast<std::size_t>(at - names.begin()) + 1)};
    });
  }
  std::optional<ltl::Formula> formula(const char* lifted) const { return formula_of(parse_lifted(lifted), bindings); }

  std::vector<std::string> names;
  ltl::Arena arena;
  Bindings bindings;
};

// Whether the grammar of prefixes lets it be spelled, and lets it end there.
bool is_allowed(const Lifted& lifted, const LiftedScope& scope) {
  LiftedPrefix prefix;
  for (const LiftedSymbol s : lifted) {
    if (!prefix.allows(s, scope)) return false;
    prefix.append(s);
  }
  return prefix.ended();
}

TEST(LiftedFormula, MacrosDenoteTheTemplatesOfCommands) {
  Letters letters({"a", "b", "c", "d", "h"});
  for (const Template& t : templates())
    EXPECT_EQ(formula_of(t.lifted, letters.bindings), ltl::parse(t.formula, letters.arena)) << print(t.lifted);
}

TEST(LiftedFormula, TemplatesWithTheirPlacesPermutedAreSpelledAndReadBack) {
  std::vector<std::string> names{"a", "b", "c", "d", "h"};
  do {
    Letters letters(names);
    for (const Template& t : templates()) {
      const ltl::Formula f = *formula_of(t.lifted, letters.bindings);
      const auto spelled = letters.spell(f);
      ASSERT_TRUE(spelled);
      EXPECT_EQ(formula_of(*spelled, letters.bindings), f) << print(*spelled) << " for " << ltl::print(f);
      EXPECT_LE(spelled->size(), t.lifted.size()) << print(*spelled) << " for " << print(t.lifted);
      EXPECT_TRUE(is_allowed(*spelled, {.slots = 5})) << print(*spelled);
    }
  } while (std::next_permutation(names.begin(), names.end()));
}

TEST(LiftedFormula, RandomFormulasAreSpelledInTheSameLanguage) {
  Letters letters({"a", "b", "c"});
  ltl::Random random(1);
  for (int i = 0; i < 400; ++i) {
    const ltl::Formula f = ltl::random_formula(random, letters.arena, {.size = 9});
    const auto spelled = letters.spell(f);
    ASSERT_TRUE(spelled) << ltl::print(f);
    const auto back = formula_of(*spelled, letters.bindings);
    ASSERT_TRUE(back) << print(*spelled);
    const auto difference = automata::difference(automata::ltlf_to_dfa(f), automata::ltlf_to_dfa(*back));
    EXPECT_FALSE(difference) << testing::show(f) << " is spelled " << print(*spelled);
  }
}

TEST(LiftedFormula, APropositionWithoutASymbolHasNoSpelling) {
  Letters letters({"a", "b"});
  EXPECT_FALSE(letters.spell(ltl::parse("F (a & moved)", letters.arena)));
}

TEST(LiftedFormula, SequencesOfActionsDenoteTheirEvents) {
  Letters letters({"a", "b"});
  const auto same = [&](const char* lifted, const char* formula) {
    EXPECT_EQ(letters.formula(lifted), ltl::parse(formula, letters.arena)) << lifted;
  };
  same("sequence turnleft end", "X turned_left");
  same("sequence #1 turnright end", "F(a & X turned_right)");
  same("sequence steps 2 #1 end", "X(moved & X(moved & F a))");
  same("atmost 1 or turned_left turned_right end",
       "!F((turned_left | turned_right) & X F(turned_left | turned_right))");
  same("sequence nth 1 #1 end", "X((moved & !a) U (moved & a))");
  same("sequence nth 2 open_left turnleft end",
       "X((moved & !open_left) U (moved & open_left & X((moved & !open_left) U (moved & open_left & X "
       "turned_left))))");
  same("sequence turnaround end", "X(turned_left & X turned_left) | X(turned_right & X turned_right)");
  same("ifelse #1 eventually #2 never #2 end", "(a & F b) | (!a & G !b)");
  same("alternate #1 #2 end", "G F a & G(a -> (a U (!a U b))) & G F b & G(b -> (b U (!b U a)))");
  same("atmost 1 turned_left", "!F(turned_left & X F turned_left)");
  same("exactly 1 moved", "F moved & !F(moved & X F moved)");
  same("stayon #1", "G a");  // nothing is moved along here
}

// Counts over finite words by the definition: a stay is a longest run of letters with a.
TEST(LiftedFormula, CountsAreNumbersOfStays) {
  Letters letters({"a"});
  for (const ltl::Trace& word : testing::all_traces({.length = 9, .atoms = 1})) {
    std::size_t stays = 0;
    for (std::size_t i = 0; i < word.size(); ++i) {
      const ltl::Proposition a{0};
      if (word[i].contains(a) && (i == 0 || !word[i - 1].contains(a))) ++stays;
    }
    for (std::size_t n = 1; n <= 4; ++n)
      for (const LiftedSymbol s : {AtLeast, AtMost, Exactly}) {
        const bool wanted = s == AtLeast ? stays >= n : s == AtMost ? stays <= n : stays == n;
        const ltl::Formula f = *formula_of(Lifted{s, number(n), slot(1)}, letters.bindings);
        EXPECT_EQ(ltl::holds(word, f), wanted) << testing::show(f, word);
      }
  }
}

TEST(LiftedFormula, WhatIsIncompleteOrNoFormulaIsRefused) {
  Letters letters({"a", "b"});
  for (const char* text : {"", "eventually", "visit #1", "#1 #2", "end", "route", "nothing", "sequence end",
                           "ordered end", "strict end", "not 3", "until #1"})
    EXPECT_THROW(formula_of(parse_lifted(text), letters.bindings), std::invalid_argument) << text;
  EXPECT_EQ(letters.formula("eventually #3"), std::nullopt);
  EXPECT_EQ(letters.formula("visit #1 ahead #1 end"), std::nullopt);
  EXPECT_THROW(parse_lifted("visit places"), ltl::FormatError);
}

// All short sequences that the grammar of prefixes allows.
void for_each_allowed(const LiftedScope& scope, std::size_t length, const LiftedPrefix& prefix, Lifted& lifted,
                      const std::function<void(const Lifted&)>& see) {
  if (prefix.ended()) return see(lifted);
  if (lifted.size() == length) return;
  for (std::size_t v = 0; v < lifted_symbols; ++v) {
    const auto s = static_cast<LiftedSymbol>(v);
    if (!prefix.allows(s, scope)) continue;
    LiftedPrefix next = prefix;
    next.append(s);
    lifted.push_back(s);
    for_each_allowed(scope, length, next, lifted, see);
    lifted.pop_back();
  }
}

TEST(LiftedPrefixes, AllShortSequencesThatAreAllowedDenoteAFormula) {
  Letters letters({"a", "b"});
  const auto count = [&](const LiftedScope& scope, std::size_t length) {
    std::size_t seen = 0;
    Lifted lifted;
    for_each_allowed(scope, length, {}, lifted, [&](const Lifted& l) {
      ++seen;
      if (l.front() == Route || l.front() == Nothing) return;
      const auto f = formula_of(l, letters.bindings);  // throws nothing
      const bool names_nothing =
          std::any_of(l.begin(), l.end(), [](LiftedSymbol s) { return is_constant(s) || is_direction(s); });
      EXPECT_TRUE(f || names_nothing) << print(l);
      const Lifted c = canonical(l);
      EXPECT_EQ(canonical(c), c) << print(l);
      EXPECT_TRUE(is_allowed(c, scope)) << print(l) << " becomes " << print(c);
      if (f) {
        EXPECT_EQ(formula_of(c, letters.bindings), f) << print(l) << " becomes " << print(c);
      }
    });
    return seen;
  };
  EXPECT_GT(count({.slots = 2}, 4), 1000U);
  EXPECT_GT(count({.slots = 1, .constants = 1, .spatial = true}, 4), 1000U);
}

// Longer ones at random, as long as they go on: they end, and within a length.
TEST(LiftedPrefixes, EveryAllowedContinuationEnds) {
  Letters letters({"a", "b", "c"});
  const LiftedScope scope{.slots = 3, .constants = 1, .spatial = true};
  ltl::Random random(2);
  for (int i = 0; i < 3000; ++i) {
    LiftedPrefix prefix;
    Lifted lifted;
    while (!prefix.ended()) {
      std::vector<LiftedSymbol> allowed;
      for (std::size_t v = 0; v < lifted_symbols; ++v)
        if (prefix.allows(static_cast<LiftedSymbol>(v), scope)) allowed.push_back(static_cast<LiftedSymbol>(v));
      ASSERT_FALSE(allowed.empty()) << print(lifted);
      std::vector<LiftedSymbol> open;  // mostly what goes on
      for (const LiftedSymbol s : allowed)
        if (operands_of(s) > 0) open.push_back(s);
      const auto& from = !open.empty() && random.chance(0.7) ? open : allowed;
      lifted.push_back(from[random.below(from.size())]);
      prefix.append(lifted.back());
      ASSERT_LE(lifted.size(), 2 * LiftedPrefix::most_symbols) << print(lifted);
    }
    if (lifted.front() == Route || lifted.front() == Nothing) continue;
    EXPECT_NO_THROW(formula_of(lifted, letters.bindings)) << print(lifted);
    EXPECT_EQ(canonical(canonical(lifted)), canonical(lifted)) << print(lifted);
  }
}

TEST(LiftedSymbols, HaveNamesThatAreReadBackAndMirror) {
  for (std::size_t v = 0; v < lifted_symbols; ++v) {
    const auto s = static_cast<LiftedSymbol>(v);
    EXPECT_EQ(lifted_symbol(name(s)), s) << name(s);
    EXPECT_EQ(mirrored(mirrored({s})), Lifted{s});
  }
  EXPECT_EQ(print(mirrored(parse_lifted("sequence turnleft left #1 end"))), "sequence turnright right #1 end");
  EXPECT_THROW(slot(13), std::out_of_range);
  EXPECT_THROW(number(0), std::out_of_range);
}

TEST(CanonicalLifted, SortsWhatHasNoOrderAndKeepsWhatHas) {
  const auto becomes = [](const char* from, const char* to) {
    EXPECT_EQ(print(canonical(parse_lifted(from))), to) << from;
  };
  becomes("visit #2 #1 #2 end", "visit #1 #2 end");
  becomes("visit #1 end", "eventually #1");
  becomes("and and #2 #1 end never #1 end end", "and never #1 end #1 #2 end");
  becomes("ordered #2 #1 end", "ordered #2 #1 end");
  becomes("sequence #1 end", "eventually #1");
  becomes("sequence turnleft end", "sequence turnleft end");
  EXPECT_THROW(canonical(parse_lifted("visit #1")), std::invalid_argument);
  EXPECT_THROW(canonical(parse_lifted("#1 #2")), std::invalid_argument);
}

// Actions, directions and conditions are spelled with the words that they have, and denote what they did.
TEST(Spelling, FindsActionsThatFollowOneAnother) {
  const Letters letters({"a", "b"});
  const auto literal = [&](ltl::Proposition p) -> std::optional<Lifted> {
    const std::string& called = letters.arena.vocabulary().name(p);
    for (const LiftedSymbol s : {TurnedLeft, TurnedRight, Moved, Start, OpenLeft, OpenRight})
      if (called == name(s)) return Lifted{s};
    const auto at = std::find(letters.names.begin(), letters.names.end(), called);
    return Lifted{slot(static_cast<std::size_t>(at - letters.names.begin()) + 1)};
  };
  for (const char* const said :
       {"sequence steps 3 turnleft end", "sequence turnright steps 2 turnleft steps 4 end", "sequence turnaround end",
        "sequence steps 2 turnaround steps 2 end", "sequence nth 2 open_left turnleft end", "sequence nth 1 #1 end",
        "sequence #1 nth 1 #2 end", "sequence #1 turnright #2 end", "ifelse #1 eventually #2 sequence steps 2 end",
        "atmost 1 or turned_left turned_right end", "exactly 1 or turned_left turned_right end",
        "and eventually #1 never turned_left end end"}) {
    const auto f = letters.formula(said);
    ASSERT_TRUE(f) << said;
    const auto spelled = parser::spell(*f, literal);
    ASSERT_TRUE(spelled) << said;
    EXPECT_EQ(print(*spelled), said);
  }
}

}  // namespace
}  // namespace waymark::parser
