// Monitors against the definition: a verdict holds for every continuation, and an open one for some but not all.
#include "libautomata/monitor/monitor.hpp"

#include <gtest/gtest.h>

#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

Monitor monitor(ltl::Formula f) { return std::get<Monitor>(ltl_to_monitor(f, {})); }

Foresight after(const Monitor& m, const std::vector<ltl::Letter>& letters) {
  Monitor::State q = m.initial();
  for (const ltl::Letter& letter : letters) q = m.next(q, letter);
  return m.verdict(q);
}

// Formulas so small that continuations u·vʷ with |uv| ≤ 3 tell satisfiable from valid.
TEST(Monitor, SaysWhatAllContinuationsHaveInCommon) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  const std::vector<ltl::Lasso> continuations = testing::all_lassos({.length = 3, .atoms = 2});
  std::vector<ltl::Formula> formulas = testing::all_formulas(arena, {.size = 3, .atoms = 2});
  for (const char* text : {"G (a -> X b)", "F (a & X b)", "a U b", "a W b", "G F a", "F a & G b", "X a <-> F b"})
    formulas.push_back(ltl::parse(text, arena));
  for (const ltl::Formula f : formulas) {
    const Monitor m = monitor(f);
    testing::for_each_trace({.length = 2, .atoms = 2}, [&](const ltl::Trace& begin) {
      const std::vector<ltl::Letter> letters(begin.begin(), begin.end());
      bool some = false, all = true;
      for (const ltl::Lasso& rest : continuations) {
        std::vector<ltl::Letter> prefix = letters, cycle;
        for (std::size_t i = 0; i < rest.size(); ++i) (i < rest.loop_start() ? prefix : cycle).push_back(rest[i]);
        const bool holds = ltl::holds(ltl::Lasso(prefix, cycle), f);
        some = some || holds;
        all = all && holds;
      }
      const Foresight expected = !some ? Foresight::False : all ? Foresight::True : Foresight::Open;
      ASSERT_EQ(after(m, letters), expected) << testing::show(f, begin);
    });
  }
}

TEST(Monitor, KnowsBeforeTheFirstLetter) {
  ltl::Arena arena;
  EXPECT_EQ(after(monitor(ltl::parse("false", arena)), {}), Foresight::False);
  EXPECT_EQ(after(monitor(ltl::parse("true", arena)), {}), Foresight::True);
  EXPECT_EQ(after(monitor(ltl::parse("F a | G !a", arena)), {}), Foresight::True);
  EXPECT_EQ(after(monitor(ltl::parse("F a", arena)), {}), Foresight::Open);
}

TEST(Monitor, KnowsWhenThereIsNothingLeftToSee) {
  ltl::Arena arena;
  const Monitor live = monitor(ltl::parse("G F a", arena));
  EXPECT_FALSE(live.is_hopeful(live.initial())) << "neither good nor bad prefixes";
  const Monitor safe = monitor(ltl::parse("G a", arena));
  EXPECT_TRUE(safe.is_hopeful(safe.initial()));
  EXPECT_FALSE(safe.is_hopeful(safe.next(safe.initial(), {})));
}

TEST(Monitor, OfSafetyIsTheMinimalDfaOfItsBadPrefixes) {
  ltl::Arena arena;
  Budget budget;
  const Dfa bad = bad_prefixes(ltl_to_tgba(ltl::parse("G (a -> X b)", arena)), budget);
  EXPECT_EQ(bad.states(), 3U);
  const Dfa none = bad_prefixes(ltl_to_tgba(ltl::parse("F a", arena)), budget);
  EXPECT_TRUE(none.is_trap(none.initial()));
}

TEST(Monitor, StopsAtTheLimits) {
  ltl::Arena arena;
  const auto result = ltl_to_monitor(ltl::parse("G (a -> X X X X b) & F (c & X X X d)", arena), {.states = 4});
  EXPECT_TRUE(std::holds_alternative<Exhausted>(result));
}

}  // namespace
}  // namespace waymark::automata
