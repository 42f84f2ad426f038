#include "libltl/structure/closure.hpp"

#include <algorithm>

namespace waymark::ltl {

std::vector<Formula> closure(Formula f) {
  std::vector<Formula> out = subformulas(f);
  for (Formula g : subformulas(f)) out.push_back(negate(g));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace waymark::ltl
