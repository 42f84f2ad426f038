// Recurrence properties: a deterministic Büchi automaton on the structure of progression.
//
// In the product of this structure with an automaton of ¬φ, the edges inside accepting components are those that some
// rejected word takes infinitely often. All other edges are marked, so every accepted word satisfies φ. Whether every
// word of φ is accepted depends on the structure and is checked.
#pragma once
#include <optional>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

// yes, no: generalised Büchi automata of φ and ¬φ. nullopt when the structure cannot carry the marks.
std::optional<TransitionRelation> deterministic_buchi(const Transitions& structure, const TransitionRelation& yes,
                                                      const TransitionRelation& no, Budget& budget);

// G F e from the minimal weak automaton of e, co-safe: every position starts a run, those that have seen a good prefix
// go, with a mark, and so do those that cannot. Unlike restarted() (weak.hpp) it forgets nothing when it marks: of an e
// of depth n it is the last n letters that count, so that automata of several e go in step. One state of budget per
// set of states. nullopt when e is valid.
std::optional<TransitionRelation> recurring(const Transitions& cosafe, Budget& budget);

// On the structure of progression: the weak automaton when φ turns out to be an obligation, else a deterministic Büchi
// automaton where there is one. yes, no: generalised Büchi automata of φ and ¬φ. Throws what the budget throws.
struct OnProgression {
  TransitionRelation automaton;  // a Büchi automaton
  bool weak;                     // every component is accepting or rejecting as a whole
};
// Nothing when f is no recurrence property; yes and no: automata of f and ¬f.
std::optional<OnProgression> on_progression(ltl::Formula f, const std::vector<ltl::Proposition>& reads,
                                            const TransitionRelation& yes, const TransitionRelation& no,
                                            Budget& budget);

// An automaton whose states all accept the same words, started in its smallest component that nothing leaves.
TransitionRelation started_inside(TransitionRelation automaton);

// Of a deterministic generalised Büchi automaton with a set at least, the words that it rejects: generalised co-Büchi.
TransitionRelation rejected_by(const TransitionRelation& automaton);

}  // namespace waymark::automata
