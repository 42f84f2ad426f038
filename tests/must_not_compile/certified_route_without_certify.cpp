// refused: private
// A route is called certified by certify() alone.
#include <utility>

#include "libplan/certify.hpp"

waymark::plan::CertifiedRoute checked(waymark::plan::Route route, const waymark::plan::Map& map,
                                      waymark::ltl::Formula f) {
#ifdef MUST_NOT_COMPILE
  static_cast<void>(map);
  return waymark::plan::CertifiedRoute(std::move(route), f);
#else
  return waymark::plan::certify(std::move(route), map, f);
#endif
}
