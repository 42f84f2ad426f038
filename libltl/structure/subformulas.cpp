// What formula.hpp says of the subformulas of a formula.
#include <algorithm>
#include <limits>
#include <unordered_map>

#include "libltl/formula.hpp"
#include "libltl/structure/walk.hpp"

namespace waymark::ltl {

std::vector<Formula> subformulas(Formula f) {
  std::vector<Formula> out = walk(f, [](Formula) { return true; });
  std::reverse(out.begin(), out.end());
  return out;
}

bool has_past(Formula f) {
  const std::vector<Formula> below = subformulas(f);
  return std::any_of(below.begin(), below.end(), [](Formula g) { return is_past(g.op()); });
}

std::vector<Proposition> propositions(Formula f) {
  std::vector<Proposition> out;
  for (Formula g : subformulas(f))
    if (g.op() == Op::Atom) out.push_back(g.proposition());
  std::sort(out.begin(), out.end());
  return out;
}

std::size_t tree_size(Formula f) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::unordered_map<Formula, std::size_t> size;
  for (Formula g : subformulas(f)) {
    std::size_t sum = 1;
    for (Formula operand : g.operands()) sum = sum > most - size.at(operand) ? most : sum + size.at(operand);
    size.emplace(g, sum);
  }
  return size.at(f);
}

}  // namespace waymark::ltl
