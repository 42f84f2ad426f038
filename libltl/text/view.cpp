#include "libltl/text/view.hpp"

#include <algorithm>
#include <span>

#include "libltl/text/bounds.hpp"

namespace waymark::ltl {
namespace {

View unary(Symbol symbol, Formula operand) { return {symbol, {{{operand}}}, {}, 0}; }
View binary(Symbol symbol, ViewOperand left, ViewOperand right) {
  return {symbol, {std::move(left), std::move(right)}, {}, 0};
}

std::vector<Formula> parts_of(Formula f, Op junction) {
  if (f.op() != junction) return {f};
  return {f.operands().begin(), f.operands().end()};
}

// all \ taken, both sorted; nothing when taken ⊄ all or nothing would be left.
std::optional<std::vector<Formula>> without(std::span<const Formula> all, const std::vector<Formula>& taken) {
  if (!std::includes(all.begin(), all.end(), taken.begin(), taken.end())) return std::nullopt;
  std::vector<Formula> rest;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(), std::back_inserter(rest));
  if (rest.empty()) return std::nullopt;
  return rest;
}

// ψ R (φ ∨ ψ) is φ W ψ, and ψ U (φ ∧ ψ) is φ M ψ.
std::optional<View> weak_or_strong(Formula f, Symbol symbol, Op junction) {
  if (f[1].op() != junction) return std::nullopt;
  auto rest = without(f[1].operands(), parts_of(f[0], junction));
  if (!rest) return std::nullopt;
  return binary(symbol, {std::move(*rest), junction}, {{f[0]}});
}

// F<=k φ and G<=k φ with strong and weak nexts, k ≥ 2, among other operands or alone.
std::optional<Bounds::Part> bounded(std::span<const Formula> parts, Op junction) {
  std::optional<Bounds::Part> found = Bounds().part(parts, junction);
  const Op next_op = junction == Op::Or ? Op::Next : Op::WeakNext;
  if (found && (found->bound.steps < 2 || found->bound.next != next_op)) found.reset();
  return found;
}

// The negated part of a disjunction that an implication has in front, or the end. Of several negated parts, one that
// was made last, from a formula older than the others, was typed in front of "->": what is made between follows it.
std::span<const Formula>::iterator premise(std::span<const Formula> parts, bool typed) {
  const auto negated = [](Formula f) { return f.op() == Op::Not; };
  if (std::count_if(parts.begin(), parts.end(), negated) == 1) return std::find_if(parts.begin(), parts.end(), negated);
  if (!typed || !negated(parts.back())) return parts.end();
  const auto older = [&](Formula f) { return parts.back()[0].id() < (negated(f) ? f[0].id() : f.id()); };
  return std::all_of(parts.begin(), parts.end() - 1, older) ? parts.end() - 1 : parts.end();
}

View of_junction(std::span<const Formula> parts, Op op, const ViewOptions& options) {
  auto bound = options.bounds ? bounded(parts, op) : std::nullopt;
  if (bound && bound->rest.empty()) {
    const Symbol symbol = op == Op::Or ? Symbol::Eventually : Symbol::Always;
    return View{symbol, {{parts_of(bound->bound.body, op), op}}, bound->bound.steps, 0};
  }
  if (const auto no = op == Op::Or ? premise(parts, options.implications) : parts.end(); no != parts.end()) {
    ViewOperand conclusion{{}, Op::Or};
    for (Formula f : parts)
      if (f != *no) conclusion.parts.push_back(f);
    return binary(Symbol::Implies, {{(*no)[0]}}, std::move(conclusion));
  }
  View out{op == Op::And ? Symbol::And : Symbol::Or, {}, {}, 0};
  for (Formula f : bound ? std::span<const Formula>(bound->rest) : parts) out.operands.push_back({{f}});
  if (bound) out.operands.push_back({std::move(bound->members), op});
  return out;
}

// X … X F<=k φ and N … N G<=k φ.
View of_next(Formula f, Symbol symbol, const ViewOptions& options) {
  const Op junction = f.op() == Op::Next ? Op::Or : Op::And;
  std::size_t steps = 0;
  Formula inner = f;
  for (; inner.op() == f.op(); inner = inner[0]) ++steps;
  if (options.bounds && options.delays && inner.op() == junction) {
    View bound = of_junction(inner.operands(), junction, options);
    if (bound.bound) {
      bound.from = steps;
      return bound;
    }
  }
  return unary(symbol, f[0]);
}

View of_until(Formula f) {
  if (f[0].op() == Op::True) return unary(Symbol::Eventually, f[1]);
  if (auto strong = weak_or_strong(f, Symbol::StrongRelease, Op::And)) return *strong;
  return binary(Symbol::Until, {{f[0]}}, {{f[1]}});
}

View of_release(Formula f) {
  if (f[0].op() == Op::False) return unary(Symbol::Always, f[1]);
  if (auto weak = weak_or_strong(f, Symbol::WeakUntil, Op::Or)) return *weak;
  return binary(Symbol::Release, {{f[0]}}, {{f[1]}});
}

// ¬(true S ¬φ) is H φ, ¬(¬φ S ¬ψ) is φ T ψ. Other negations of S stay: ¬φ may be no stored formula.
View of_not_since(Formula f) {
  const auto is_not = [](Formula g) { return g.op() == Op::Not; };
  if (!is_not(f[0][1])) return unary(Symbol::Not, f[0]);
  if (f[0][0].op() == Op::True) return unary(Symbol::Historically, f[0][1][0]);
  if (is_not(f[0][0])) return binary(Symbol::Triggered, {{f[0][0][0]}}, {{f[0][1][0]}});
  return unary(Symbol::Not, f[0]);
}

View of_since(Formula f) {
  if (f[0].op() == Op::True) return unary(Symbol::Once, f[1]);
  return binary(Symbol::Since, {{f[0]}}, {{f[1]}});
}

View of_not(Formula f) {
  if (f[0].op() == Op::Since) return of_not_since(f);
  if (f[0].op() == Op::Yesterday && f[0][0].op() == Op::Not) return unary(Symbol::WeakYesterday, f[0][0][0]);
  if (f[0].op() != Op::Iff) return unary(Symbol::Not, f[0]);
  return binary(Symbol::ExclusiveOr, {{f[0][0]}}, {{f[0][1]}});
}

}  // namespace

View view(Formula f, const ViewOptions& options) {
  switch (f.op()) {
    case Op::Not: return of_not(f);
    case Op::And:
    case Op::Or: return of_junction(f.operands(), f.op(), options);
    case Op::Iff: return binary(Symbol::Iff, {{f[0]}}, {{f[1]}});
    case Op::Next: return of_next(f, Symbol::Next, options);
    case Op::WeakNext: return of_next(f, Symbol::WeakNext, options);
    case Op::Until: return of_until(f);
    case Op::Release: return of_release(f);
    case Op::Yesterday: return unary(Symbol::Yesterday, f[0]);
    case Op::Since: return of_since(f);
    case Op::False:
    case Op::True:
    case Op::Atom: break;  // excluded by the contract
  }
  return {};
}

View view(const ViewOperand& operand, const ViewOptions& options) {
  return operand.parts.size() == 1 ? view(operand.parts.front(), options)
                                   : of_junction(operand.parts, operand.junction, options);
}

}  // namespace waymark::ltl
