// refused: cannot convert|could not convert|no viable conversion
// The two halves of a product state are both numbers inside, and never each other.
#include "libplan/product/graph.hpp"

bool accepting(const waymark::automata::Dfa& dfa, const waymark::plan::ProductState& state) {
#ifdef MUST_NOT_COMPILE
  return dfa.is_accepting(state.pose);
#else
  return dfa.is_accepting(state.task);
#endif
}
