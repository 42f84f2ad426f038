// Runtime monitors: the verdict of a finite prefix of a word about an LTL formula over infinite words.
//
// A prefix is bad when no continuation satisfies φ, and good when every continuation does; the verdict is false, true
// or open. In a trimmed automaton of φ, the set of reached states is empty exactly after bad prefixes, and in that of
// ¬φ after good prefixes. Both subset constructions are minimised. A state of the monitor is a pair of their states.
// Equal futures give equal pairs, so the monitor is minimal. [BLS11, Sec. 3]; the sets are leaves of diagrams here.
#pragma once
#include <cstdint>
#include <optional>
#include <variant>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

// The non-empty words after which no run of a trimmed automaton is left: the bad prefixes of its language. Minimal.
// Throws what the budget throws.
Dfa bad_prefixes(const Automaton& trimmed, Budget& budget);

enum class Foresight : std::uint8_t { False, Open, True };  // what is known of all continuations

class Monitor {
 public:
  struct State {           // of both automata
    StateId bad, good;     // in bad() and good()
    bool started = false;  // some letter was read
    friend bool operator==(const State&, const State&) = default;
  };

  Monitor(Dfa bad, Dfa good, Foresight at_first) : bad_(std::move(bad)), good_(std::move(good)), at_first_(at_first) {}

  State initial() const { return {bad_.initial(), good_.initial(), false}; }  // before the first letter
  State next(State q, const ltl::Letter& letter) const {                      // letters over vocabulary(), O(|reads|)
    return {bad_.next(q.bad, letter), good_.next(q.good, letter), true};
  }
  Foresight verdict(State q) const;  // of the prefix that was read
  // False where the verdict can no longer change from open: to go on monitoring is of no use.
  bool is_hopeful(State q) const;

  const ltl::Vocabulary& vocabulary() const { return bad_.vocabulary(); }  // of the formula
  const Dfa& bad() const { return bad_; }                                  // accepts the bad prefixes
  const Dfa& good() const { return good_; }                                // accepts the good prefixes

 private:
  Dfa bad_, good_;
  Foresight at_first_;  // the verdict before the first letter
};

// The minimal weak deterministic automaton of an obligation without past operators, over propositions(f); nullopt for
// other formulas, and where the budget of that construction does not do. Throws Budget::Exceeded when stopped.
std::optional<Transitions> weak_of_obligation(ltl::Formula f, const ltl::Limits& limits);

// From the weak deterministic automaton of an obligation, else by subset constructions. Gives up at the limits.
std::variant<Monitor, Exhausted> ltl_to_monitor(ltl::Formula f, const ltl::Limits& limits);

}  // namespace waymark::automata
