// refused: no matching function|no matching constructor
// A formula is a node of an arena: there is none without one.
#include "libltl/formula.hpp"

waymark::ltl::Formula truth(waymark::ltl::Arena& arena) {
#ifdef MUST_NOT_COMPILE
  static_cast<void>(arena);
  return waymark::ltl::Formula();
#else
  return arena.constant(true);
#endif
}
