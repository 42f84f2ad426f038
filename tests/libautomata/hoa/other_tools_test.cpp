// Automata as other tools print them, against the formulas that they stand for: on all small lassos.
#include <gtest/gtest.h>

#include "libautomata/hoa/omega.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

struct Sample {
  const char* tool;
  const char* formula;
  const char* text;
};

constexpr Sample samples[] = {
    {"Spot", "G F a",
     R"HOA(HOA: v1
name: "GFa"
States: 1
Start: 0
AP: 1 "a"
acc-name: Buchi
Acceptance: 1 Inf(0)
properties: trans-labels explicit-labels trans-acc colored complete
properties: deterministic stutter-invariant very-weak
spot.highlight.states: 0 1
--BODY--
State: 0
[0] 0 {0}
[!0] 0
--END--
)HOA"},
    {"Spot", "F G a",
     R"HOA(HOA: v1.1
name: "FGa"
States: 2
Start: 0
AP: 1 "a"
acc-name: Buchi
Acceptance: 1 Inf(0)
properties: trans-labels explicit-labels state-acc !complete
properties: !deterministic exist-branch stutter-invariant
--BODY--
State: 0
[t] 0
[0] 1
State: 1 {0}
[0] 1
--END--
)HOA"},
    {"Rabinizer", "a U b",
     R"HOA(HOA: v1
tool: "Rabinizer" "infty"
name: "Automaton for a U b"
owner: "jan"
States: 2 /* comment */
Start: 0
acc-name: generalized-Rabin 2 1 0
Acceptance: 3 (Fin(0) & Inf(1)) | (Fin(2))
AP: 2 "a" "b"
properties: deterministic
properties: unambiguous
properties: trans-acc
properties: no-univ-branch
--BODY--
State: 0 "G((a) & (b))"
[(0 & !1)] 0 {0 2}
[(1)] 1 {0}
State: 1 "true"
[t] 1 {1}
--END--
)HOA"},
    {"Owl", "G F p0",
     R"HOA(HOA: v1
tool: "ltl2dpa" "21.0"
owlArgs: "ltl2dpa"
Start: 0
acc-name: parity min odd 3
Acceptance: 3 Fin(0) & (Inf(1) | Fin(2))
properties: trans-acc no-univ-branch
properties: deterministic unambiguous
properties: complete
AP: 1 "p0"
--BODY--
State: 0 "{F(p0) :: 0}"
[0] 0 {1}
[!0] 0 {2}
--END--
)HOA"},
    {"ltl3ba", "G (req -> F ack)",
     R"HOA(HOA: v1
tool: "ltl3ba" "1.1.3"
name: "BA for G(req -> F ack)"
States: 2
Start: 0
acc-name: Buchi
Acceptance: 1 Inf(0)
AP: 2 "req" "ack"
properties: trans-labels explicit-labels state-acc no-univ-branch very-weak
--BODY--
State: 0 "accept_init" {0}
  [(!0) | (1)] 0
  [(0 & !1)] 1
State: 1 "T0_S1"
  [(1)] 0
  [(!1)] 1
--END--
)HOA"},
    {"hand", "!a & G F a",
     R"HOA(HOA: v1
States: 3
Acceptance: 1 Inf(0)
acc-name: Buchi
AP: 1 "a"
Start: 1
Alias: @a 0
Alias: @na !@a
properties: state-labels
--BODY--
State: [@a] 0 {0}
0 1
State: [@na] 1 
0 2
State: [t] 2
2 0 1
--END--
)HOA"},
    {"hand", "true",
     R"HOA(HOA: v1
AP: 2 "a" "b"
Start: 0
States: 2
acc-name: all
Acceptance: 0 t
--BODY--
State: 0 0 1 0 1
State: 1 1 1 1 0
--END--
)HOA"},
    {"ltl2dstar", "G F !p0",
     R"HOA(HOA: v1
name: "ltl2dstar"
tool: "ltl2dstar" "0.5.3"
States: 2
Acceptance: 2 (Fin(0) | Inf(1))
acc-name: Streett 1
Start: 0
AP: 1 "p0"
comment: "Streett{Safra[NBA=2]}"
properties: implicit-labels state-acc deterministic complete explicit-labels
--BODY--
State: 0 {0}
1
0
State: 1 {1}
1
0
--END--
)HOA"},
    {"LTL3HOA", "F a & G b",
     R"HOA(HOA: v1
tool: "LTL3HOA" "1.0.0"
name: "VWAA for F a & G b"
States: 3
Start: 0&1
acc-name: co-Buchi
Acceptance: 1 Fin(0)
AP: 2 "a" "b"
properties: univ-branch very-weak trans-labels explicit-labels trans-acc
--BODY--
State: 0 "F(a)"
[!0] 0 {0}
[0] 2
State: 1
[1] 1&2
State: 2 "true"
[t] 2
--END--
)HOA"},
};

TEST(OtherTools, PrintWhatTheFormulaMeans) {
  for (const Sample& sample : samples) {
    const Automaton automaton = read_omega_hoa(sample.text, sample.tool);
    ltl::Arena arena(automaton.vocabulary());
    const ltl::Formula f = ltl::parse(sample.formula, arena);
    ASSERT_EQ(arena.vocabulary().size(), automaton.vocabulary().size()) << sample.tool;
    for (const ltl::Lasso& word : testing::all_lassos({.length = 4, .atoms = automaton.vocabulary().size()}))
      ASSERT_EQ(referee::accepts(automaton, word), ltl::holds(word, f))
          << sample.tool << ": " << testing::show(f, word);
  }
}

}  // namespace
}  // namespace waymark::automata
