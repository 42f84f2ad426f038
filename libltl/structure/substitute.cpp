#include "libltl/structure/substitute.hpp"

#include <unordered_map>
#include <vector>

namespace waymark::ltl {

Formula substitute(Formula f, Arena& to, const std::function<Formula(Proposition)>& image_of) {
  std::unordered_map<Formula, Formula> image;
  for (Formula g : subformulas(f)) {
    std::vector<Formula> args;
    for (Formula operand : g.operands()) args.push_back(image.at(operand));
    const Formula copy = [&] {
      switch (g.op()) {
        case Op::False: return to.constant(false);
        case Op::True: return to.constant(true);
        case Op::Atom: return image_of(g.proposition());
        case Op::Not: return negate(args[0]);
        case Op::And: return conjunction(to, args);
        case Op::Or: return disjunction(to, args);
        case Op::Iff: return iff(args[0], args[1]);
        case Op::Next: return next(args[0]);
        case Op::WeakNext: return weak_next(args[0]);
        case Op::Until: return until(args[0], args[1]);
        case Op::Release: return release(args[0], args[1]);
      }
      return to.constant(false);  // unreachable: -Werror=switch
    }();
    image.emplace(g, copy);
  }
  return image.at(f);
}

Formula transfer(Formula f, Arena& to) {
  return substitute(f, to, [&](Proposition p) { return to.atom(f.arena().vocabulary().name(p)); });
}

}  // namespace waymark::ltl
