#include "libltl/meaning/progress.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace waymark::ltl {
namespace {

// The subformulas that are read now: those not below a next. Operands before operators.
std::vector<Formula> read_now(Formula f) {
  std::vector<Formula> out, stack{f};
  std::unordered_set<Formula> seen{f};
  while (!stack.empty()) {
    const Formula g = stack.back();
    stack.pop_back();
    out.push_back(g);
    if (g.op() == Op::Next || g.op() == Op::WeakNext) continue;
    for (Formula operand : g.operands())
      if (seen.insert(operand).second) stack.push_back(operand);
  }
  std::sort(out.begin(), out.end());  // operands have smaller ids
  return out;
}

// One operator; `after`: its operands progressed, none for the nexts.
Formula step(Formula f, const std::vector<Formula>& after, const Letter& letter, Semantics semantics) {
  Arena& arena = f.arena();
  const bool finite = semantics == Semantics::Finite;
  switch (f.op()) {
    case Op::False:
    case Op::True: return f;
    case Op::Atom: return arena.constant(letter.contains(f.proposition()));
    case Op::Not: return negate(after[0]);
    case Op::And: return conjunction(arena, after);
    case Op::Or: return disjunction(arena, after);
    case Op::Iff: return iff(after[0], after[1]);
    case Op::Next: return finite ? conjunction(f[0], eventually(arena.constant(true))) : f[0];
    case Op::WeakNext: return finite ? disjunction(f[0], always(arena.constant(false))) : f[0];
    case Op::Until: return disjunction(after[1], conjunction(after[0], f));
    case Op::Release: return conjunction(after[1], disjunction(after[0], f));
  }
  return f;  // unreachable: -Werror=switch
}

}  // namespace

Formula progress(Formula f, const Letter& letter, Semantics semantics) {
  std::unordered_map<Formula, Formula> image;
  std::vector<Formula> after;
  for (Formula g : read_now(f)) {
    after.clear();
    if (g.op() != Op::Next && g.op() != Op::WeakNext)
      for (Formula operand : g.operands()) after.push_back(image.at(operand));
    image.emplace(g, step(g, after, letter, semantics));
  }
  return image.at(f);
}

bool accepts_empty(Formula f) {
  std::unordered_map<Formula, bool> value;
  const auto at = [&](Formula g) { return value.at(g); };
  for (Formula g : subformulas(f)) {
    const auto operands = g.operands();
    const bool accepts = [&] {
      switch (g.op()) {
        case Op::False:
        case Op::Atom:
        case Op::Next:
        case Op::Until: return false;
        case Op::True:
        case Op::WeakNext:
        case Op::Release: return true;
        case Op::Not: return !at(g[0]);
        case Op::And: return std::all_of(operands.begin(), operands.end(), at);
        case Op::Or: return std::any_of(operands.begin(), operands.end(), at);
        case Op::Iff: return at(g[0]) == at(g[1]);
      }
      return false;  // unreachable: -Werror=switch
    }();
    value.emplace(g, accepts);
  }
  return value.at(f);
}

}  // namespace waymark::ltl
