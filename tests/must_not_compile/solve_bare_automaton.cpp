// refused: no matching function|invalid initialization of reference|could not convert|no viable conversion
// What is solved is a product with a map: an automaton alone has no poses to go to.
#include "libplan/solve/shortest_route.hpp"

waymark::plan::Outcome answer(const waymark::plan::MapProduct& product, const waymark::automata::Dfa& dfa) {
#ifdef MUST_NOT_COMPILE
  static_cast<void>(product);
  return waymark::plan::solve(dfa, waymark::plan::ShortestRoute{});
#else
  static_cast<void>(dfa);
  return waymark::plan::solve(product, waymark::plan::ShortestRoute{});
#endif
}
