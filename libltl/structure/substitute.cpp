#include "libltl/structure/substitute.hpp"

#include <unordered_map>
#include <vector>

namespace waymark::ltl {

Formula with_operands(Formula g, Arena& to, std::span<const Formula> operands) {
  switch (g.op()) {
    case Op::False: return to.constant(false);
    case Op::True: return to.constant(true);
    case Op::Atom: return to.atom(g.proposition());
    case Op::Not: return negate(operands[0]);
    case Op::And: return conjunction(to, operands);
    case Op::Or: return disjunction(to, operands);
    case Op::Iff: return iff(operands[0], operands[1]);
    case Op::Next: return next(operands[0]);
    case Op::WeakNext: return weak_next(operands[0]);
    case Op::Until: return until(operands[0], operands[1]);
    case Op::Release: return release(operands[0], operands[1]);
    case Op::Yesterday: return yesterday(operands[0]);
    case Op::Since: return since(operands[0], operands[1]);
  }
  return to.constant(false);  // unreachable: -Werror=switch
}

Formula substitute(Formula f, Arena& to, const std::function<Formula(Proposition)>& image_of) {
  std::unordered_map<Formula, Formula> image;
  for (Formula g : subformulas(f)) {
    std::vector<Formula> args;
    for (Formula operand : g.operands()) args.push_back(image.at(operand));
    image.emplace(g, g.op() == Op::Atom ? image_of(g.proposition()) : with_operands(g, to, args));
  }
  return image.at(f);
}

Formula transfer(Formula f, Arena& to) {
  return substitute(f, to, [&](Proposition p) { return to.atom(f.arena().vocabulary().name(p)); });
}

}  // namespace waymark::ltl
