#include "libltl/rewriting/nnf.hpp"

#include <vector>

#include "libltl/structure/by_subformula.hpp"

namespace waymark::ltl {
namespace {

struct Both {  // normal forms of φ and of ¬φ
  Formula yes, no;
};

Both of_iff(Both a, Both b, bool expand) {
  if (!expand) return {iff(a.yes, b.yes), exclusive_or(a.yes, b.yes)};
  const Formula neither = conjunction(a.no, b.no), both = conjunction(a.yes, b.yes);
  const Formula yes = disjunction(both, neither);
  const Formula second = conjunction(a.no, b.yes), first = conjunction(a.yes, b.no);
  return {yes, disjunction(first, second)};
}

Both of_junction(Formula f, const std::vector<Both>& operands) {
  std::vector<Formula> yes, no;
  for (const Both& operand : operands) {
    yes.push_back(operand.yes);
    no.push_back(operand.no);
  }
  Arena& arena = f.arena();
  if (f.op() == Op::And) return {conjunction(arena, yes), disjunction(arena, no)};
  return {disjunction(arena, yes), conjunction(arena, no)};
}

// A negation before a past operator stays there, as before a proposition.
Both with_negation(Formula f) { return {f, negate(f)}; }

Both normal_forms(Formula f, const std::vector<Both>& operands, bool expand) {
  switch (f.op()) {
    case Op::False:
    case Op::True:
    case Op::Atom: return {f, negate(f)};
    case Op::Not: return {operands[0].no, operands[0].yes};
    case Op::And:
    case Op::Or: return of_junction(f, operands);
    case Op::Iff: return of_iff(operands[0], operands[1], expand);
    case Op::Next: return {next(operands[0].yes), weak_next(operands[0].no)};
    case Op::WeakNext: return {weak_next(operands[0].yes), next(operands[0].no)};
    case Op::Until: return {until(operands[0].yes, operands[1].yes), release(operands[0].no, operands[1].no)};
    case Op::Release: return {release(operands[0].yes, operands[1].yes), until(operands[0].no, operands[1].no)};
    case Op::Yesterday: return with_negation(yesterday(operands[0].yes));
    case Op::Since: return with_negation(since(operands[0].yes, operands[1].yes));
  }
  return {f, negate(f)};  // unreachable: -Werror=switch
}

Formula transform(Formula f, bool expand) {
  std::vector<Both> operands;
  const auto both = [&](Formula g, const BySubformula<Both>& known) {
    operands.clear();
    for (Formula operand : g.operands()) operands.push_back(known.at(operand));
    return normal_forms(g, operands, expand);
  };
  return BySubformula<Both>(f, both).top().yes;
}

}  // namespace

Formula Opposites::of(Formula f) {
  std::vector<Formula> open{f};
  std::vector<Both> operands;
  while (!open.empty()) {
    const Formula g = open.back();
    const std::size_t before = open.size();
    if (!known_.contains(g))
      for (Formula operand : g.operands())
        if (!known_.contains(operand)) open.push_back(operand);
    if (open.size() > before) continue;
    open.pop_back();
    if (known_.contains(g)) continue;
    operands.clear();
    for (Formula operand : g.operands()) {
      const auto& [yes, no] = known_.at(operand);
      operands.push_back({yes, no});
    }
    const Both both = normal_forms(g, operands, false);
    known_.emplace(g, std::pair(both.yes, both.no));
  }
  return known_.at(f).second;
}

Formula nnf(Formula f) { return transform(f, true); }
Formula nnf_keeping_iff(Formula f) { return transform(f, false); }

}  // namespace waymark::ltl
