// Obligations: the minimal weak deterministic automaton, by progression.
//
// The closure under progression is a deterministic structure whose states are residual formulas. For an obligation, all
// loops of one component have the same verdict: one loop is evaluated by the definition and colours the component.
// Transient states take the colour that makes states of one language equal. Minimisation as for finite words then gives
// the minimal automaton [Loe01]. Trying this on any formula and checking the result is [DEK07].
#pragma once
#include <optional>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

// Progression closed off: deterministic, complete, nothing accepting.
Transitions progression(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget);

// … and what is left to satisfy, by state: formulas of the same arena, in no normal form.
struct Progression {
  Transitions structure;              // deterministic; nothing accepts yet
  std::vector<ltl::Formula> meaning;  // by state, the residual formula
};
// The closure of f under progression.
Progression progression_with_meaning(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget);

// Complete; accepting states are those whose loops accept. The language is φ's when φ is an obligation, else any.
Transitions weak_deterministic(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget);
Transitions weak_deterministic(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Transitions structure,
                               Budget& budget);  // on the structure of progression()

// The same as Büchi automaton with marks on states; all runs accept where no state rejects. `complement` exchanges
// accepting and rejecting states; `trim` removes the rejecting sink.
struct AsBuchi {
  bool complement = false;  // accept what the weak automaton rejects
  bool trim = true;         // leave out states from which nothing is accepted
};
// As a Büchi automaton with marks on edges.
TransitionRelation as_buchi(const Transitions& weak, const AsBuchi& options);

// G e from the automaton of e, eventual and co-safe: a good prefix of e is read over and over. A branch into the state
// that accepts everything leads back to the initial state with a mark. nullopt when some run accepts elsewhere, or the
// initial state is that state.
std::optional<TransitionRelation> restarted(const TransitionRelation& automaton);

}  // namespace waymark::automata
