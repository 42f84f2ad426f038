#include "libltl/text/view.hpp"

#include <algorithm>
#include <span>

namespace waymark::ltl {
namespace {

View unary(Symbol symbol, Formula operand) { return {symbol, {{{operand}}}, {}}; }
View binary(Symbol symbol, ViewOperand left, ViewOperand right) {
  return {symbol, {std::move(left), std::move(right)}, {}};
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

struct Bounded {
  std::vector<Formula> body;
  std::size_t k = 0;
};

// f = φ ∨ X(φ ∨ X(… φ)): φ and the number of nexts. `junction`, `next_op`: Or, Next for F<=k; And, WeakNext for G<=k.
// The outermost level decides what φ is; every further level must repeat it.
std::optional<Bounded> bounded_at(std::span<const Formula> parts, std::size_t i, Op junction, Op next_op) {
  Bounded out;
  for (Formula g : parts)
    if (g != parts[i]) out.body.push_back(g);
  Formula level = parts[i][0];
  for (out.k = 1;; ++out.k) {
    if (parts_of(level, junction) == out.body) return out;
    if (level.op() != junction) return std::nullopt;
    const auto rest = without(level.operands(), out.body);
    if (!rest || rest->size() != 1 || rest->front().op() != next_op) return std::nullopt;
    level = rest->front()[0];
  }
}

std::optional<View> bounded(std::span<const Formula> parts, Op junction) {
  const Op next_op = junction == Op::Or ? Op::Next : Op::WeakNext;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].op() != next_op) continue;
    auto found = bounded_at(parts, i, junction, next_op);
    if (!found || found->k < 2) continue;
    const Symbol symbol = junction == Op::Or ? Symbol::Eventually : Symbol::Always;
    return View{symbol, {{std::move(found->body), junction}}, found->k};
  }
  return std::nullopt;
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
  if (options.bounds)
    if (auto found = bounded(parts, op)) return *found;
  if (const auto no = op == Op::Or ? premise(parts, options.implications) : parts.end(); no != parts.end()) {
    ViewOperand conclusion{{}, Op::Or};
    for (Formula f : parts)
      if (f != *no) conclusion.parts.push_back(f);
    return binary(Symbol::Implies, {{(*no)[0]}}, std::move(conclusion));
  }
  View out{op == Op::And ? Symbol::And : Symbol::Or, {}, {}};
  for (Formula f : parts) out.operands.push_back({{f}});
  return out;
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
    case Op::Next: return unary(Symbol::Next, f[0]);
    case Op::WeakNext: return unary(Symbol::WeakNext, f[0]);
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
