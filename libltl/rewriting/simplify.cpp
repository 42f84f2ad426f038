#include "libltl/rewriting/simplify.hpp"

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/rewrite_rules.hpp"
#include "libltl/structure/by_subformula.hpp"

namespace waymark::ltl {
namespace {

bool is_boolean(Op op) { return op == Op::Not || op == Op::And || op == Op::Or || op == Op::Iff; }

Formula rebuild(Formula f, const std::vector<Formula>& operands) {
  switch (f.op()) {
    case Op::False:
    case Op::True:
    case Op::Atom: return f;
    case Op::Not: return negate(operands[0]);
    case Op::And: return conjunction(f.arena(), operands);
    case Op::Or: return disjunction(f.arena(), operands);
    case Op::Iff: return iff(operands[0], operands[1]);
    case Op::Next: return next(operands[0]);
    case Op::WeakNext: return weak_next(operands[0]);
    case Op::Until: return until(operands[0], operands[1]);
    case Op::Release: return release(operands[0], operands[1]);
    case Op::Yesterday: return yesterday(operands[0]);
    case Op::Since: return since(operands[0], operands[1]);
  }
  return f;  // unreachable: -Werror=switch
}

// The subformulas that the empty word can be read on: not below a temporal operator.
std::unordered_set<Formula> top_layer(Formula f) {
  std::unordered_set<Formula> out{f};
  std::vector<Formula> stack{f};
  while (!stack.empty()) {
    const Formula g = stack.back();
    stack.pop_back();
    if (!is_boolean(g.op())) continue;
    for (Formula operand : g.operands())
      if (out.insert(operand).second) stack.push_back(operand);
  }
  return out;
}

class Simplifier {
 public:
  Simplifier(Over over, Implication::Oracle implies, const std::stop_token& stop)
      : over_(over), implies_(std::move(implies)), stop_(stop) {}

  // Every subformula once, operands first. A subformula that occurs both at the top and below a temporal operator
  // has two images.
  Formula pass(Formula f) {
    const bool careful = over_ == Over::Rest;
    const std::unordered_set<Formula> top = careful ? top_layer(f) : std::unordered_set<Formula>{};
    std::unordered_map<Formula, Formula> outer;
    std::vector<Formula> operands;
    const auto rewritten = [&](Formula g, const BySubformula<Formula>& inner) {
      operands.clear();
      for (Formula operand : g.operands()) operands.push_back(inner.at(operand));
      const Formula image = rewrite(rebuild(g, operands), false);
      if (!top.contains(g)) return image;
      if (is_boolean(g.op())) {
        operands.clear();
        for (Formula operand : g.operands()) operands.push_back(outer.at(operand));
      }
      outer.emplace(g, rewrite(rebuild(g, operands), true));
      return image;
    };
    const BySubformula<Formula> inner(f, rewritten);
    return careful ? outer.at(f) : inner.top();
  }

 private:
  // The outermost operator only, until no rule applies.
  Formula rewrite(Formula f, bool keep_empty) {
    bool changed = true;
    while (changed) {
      changed = false;
      for (const RewriteRule& rule : rewrite_rules()) {
        if (!(over_ == Over::Infinite ? rule.infinite : rule.finite)) continue;
        if (stop_.stop_requested()) return f;
        const auto result = rule.apply(f, implies_);
        if (!result || (keep_empty && accepts_empty(*result) != accepts_empty(f))) continue;
        f = *result;
        changed = true;
        break;
      }
    }
    return f;
  }

  Over over_;
  Implication implies_;
  const std::stop_token& stop_;
};

}  // namespace

Formula simplify(Formula f, Over over) { return simplify(f, over, {}); }

Formula simplify(Formula f, Over over, Implication::Oracle implies, const std::stop_token& stop) {
  Simplifier simplifier(over, std::move(implies), stop);
  Formula before = f;
  f = nnf_keeping_iff(f);
  do {
    before = f;
    f = simplifier.pass(f);
  } while (f != before && !stop.stop_requested());
  return f;
}

}  // namespace waymark::ltl
