// refused: cannot convert|could not convert|no viable conversion
// Poses of a map and states of an automaton are both numbers inside, and never each other.
#include "libautomata/finite/dfa.hpp"
#include "libplan/world/map.hpp"

#ifdef MUST_NOT_COMPILE
bool accepting(const waymark::automata::Dfa& dfa, waymark::plan::PoseId s) { return dfa.is_accepting(s); }
#else
bool accepting(const waymark::automata::Dfa& dfa, waymark::automata::StateId s) { return dfa.is_accepting(s); }
#endif
