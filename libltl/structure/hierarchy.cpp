// Levels from the operands up. A class and its dual are never more than one apart.
#include "libltl/structure/hierarchy.hpp"

#include <algorithm>

#include "libltl/structure/by_subformula.hpp"

namespace waymark::ltl {
namespace {

// Under a temporal operator only Σ and Π count: what was a Boolean combination is in one of them or it is not.
Level temporal(std::uint32_t sigma, std::uint32_t pi) { return {sigma, pi, std::min(sigma, pi)}; }

Level joined(Level a, Level b) {
  return {std::max(a.sigma, b.sigma), std::max(a.pi, b.pi), std::max(a.delta, b.delta)};
}

}  // namespace

Level level(Formula f) {
  const auto of = [](Formula g, const BySubformula<Level>& known) -> Level {
    Level all;
    for (Formula operand : g.operands()) all = joined(all, known.at(operand));
    const std::uint32_t sigma = std::max(1U, all.sigma), pi = std::max(1U, all.pi);
    switch (g.op()) {
      case Op::False:
      case Op::True:
      case Op::Atom:
      case Op::And:
      case Op::Or:
      case Op::Yesterday:
      case Op::Since: return all;
      case Op::Not: return {all.pi, all.sigma, all.delta};
      case Op::Iff: return {std::max(all.sigma, all.pi), std::max(all.sigma, all.pi), all.delta};
      case Op::Next:
      case Op::WeakNext: return temporal(sigma, pi);
      case Op::Until: return temporal(sigma, sigma + 1);
      case Op::Release: return temporal(pi + 1, pi);
    }
    return all;  // unreachable: -Werror=switch
  };
  return BySubformula<Level>(f, of).top();
}

}  // namespace waymark::ltl
