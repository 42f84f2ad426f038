// refused: private|no matching (constructor|function)|is private within this context
// Soundness for MDPs is proved of constructions, not seen on automata: only a translation makes an MdpSafe.
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"

waymark::automata::MdpSafe declared(const waymark::automata::Dpa& dpa,
                                    const waymark::automata::LimitDeterministic& by_hand) {
#ifdef MUST_NOT_COMPILE
  static_cast<void>(dpa);
  return waymark::automata::MdpSafe(by_hand, {}, {});
#else
  static_cast<void>(by_hand);
  return waymark::automata::limit_deterministic(dpa);
#endif
}
