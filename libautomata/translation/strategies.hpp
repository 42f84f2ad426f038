// The strategies of the constructions on infinite words as tables: what one attempt of each may spend, and the sets of
// docs/performance.md that this was settled on. A formula of everyday size meets none of these budgets.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace waymark::automata {

struct Strategy {
  std::string_view name;        // what is tried
  std::size_t steps, states;    // SIZE_MAX states: as many as the caller allows
  std::string_view settled_on;  // sets of formulas
};

// Of ltl_to_tgba and ltl_to_buchi.
struct BuchiStrategies {
  // Each attempt with its steps and states.
  Strategy tableau{"tableau, or minimal weak automaton of an obligation", 400'000'000, SIZE_MAX, "random4, dwyer"};
  // The tableau of ¬φ, the weak automaton of what may be an obligation, G of co-safe formulas, the formula in which
  // nothing was pulled out.
  Strategy second{"another automaton beside that one", 2'000'000, 2'000, "random4, liberouter"};
  Strategy simulation{"reduction by simulation and components", 30'000'000, SIZE_MAX, "random4, random6"};
  Strategy levels{"one way to count levels, when those before it have spent nearly all", 100'000, SIZE_MAX,
                  "random4, dwyer"};
  Strategy merging{"language-preserving state merging", 3'000'000, SIZE_MAX,
                   "lily, families, random4, random6, pattern_conj"};
};

// Of ltl_to_parity, ltl_to_rabin and ltl_to_generic.
struct ParityStrategies {
  // Each attempt with its steps and states.
  Strategy weak{"minimal weak automaton of an obligation", 400'000'000, SIZE_MAX, "random4, dwyer"};
  Strategy windows{"G F of co-safe formulas by the letters that they look back at", 400'000'000, 2'000,
                   "random4, dwyer"};
  Strategy parts{"product of the parts of a Boolean combination", 200'000'000, SIZE_MAX, "pattern_conj"};
  Strategy paritising{"parity by alternating cycles", 200'000'000, SIZE_MAX, "pattern_conj"};
  Strategy determinising{"determinisation of φ and of ¬φ; then ten times as many states", 2'000'000'000, 1'000,
                         "random6"};
  Strategy normal_form{"product of the parts of the normal form in Δ₂", 200'000'000, SIZE_MAX,
                       "300 random formulas of 30 to 50 nodes"};
  Strategy reduction{"comparison of languages", 100'000'000, SIZE_MAX, "random4"};
};

// Of ltl_to_ldba, from the parity automaton.
struct LdbaStrategies {
  // Each attempt with its steps and states.
  Strategy colours{"jumps by colours, languages compared", 50'000'000, SIZE_MAX, "random4, dwyer"};
  Strategy theorem{"jumps by the master theorem", 50'000'000, SIZE_MAX, "random4, dwyer"};
};

}  // namespace waymark::automata
