#include "libautomata/deterministic/split.hpp"

#include <optional>
#include <span>
#include <utility>

#include "libautomata/budget.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/separate.hpp"
#include "libltl/structure/fragment.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Op;

// F φ and G φ, which are φ where that says so already.
Formula some_time(Formula f) { return ltl::purity(f).eventual ? f : ltl::eventually(f); }
Formula every_time(Formula f) { return ltl::purity(f).universal ? f : ltl::always(f); }

struct Junction {
  Op op;
  std::vector<Formula> operands;
};

template <class Make>
Junction each(Op op, std::span<const Formula> operands, const Make& make) {
  Junction out{op, {}};
  for (Formula g : operands) out.operands.push_back(make(g));
  return out;
}

std::optional<Junction> junction(Formula f) {
  const auto same = [](Formula g) { return g; };
  if (f.op() == Op::And || f.op() == Op::Or) return each(f.op(), f.operands(), same);
  if (f.op() == Op::Next && (f[0].op() == Op::And || f[0].op() == Op::Or))
    return each(f[0].op(), f[0].operands(), [](Formula g) { return ltl::next(g); });
  if (is_eventually(f)) {
    if (f[1].op() == Op::Or) return each(Op::Or, f[1].operands(), some_time);
    if (is_always(f[1]) && f[1][1].op() == Op::And)
      return each(Op::And, f[1][1].operands(), [](Formula g) { return some_time(every_time(g)); });
  }
  if (is_always(f)) {
    if (f[1].op() == Op::And) return each(Op::And, f[1].operands(), every_time);
    if (is_eventually(f[1]) && f[1][1].op() == Op::Or)
      return each(Op::Or, f[1][1].operands(), [](Formula g) { return every_time(some_time(g)); });
  }
  return std::nullopt;
}

}  // namespace

bool is_obligation(Formula f) { return ltl::fragments(f, ltl::Semantics::Infinite).obligation; }

std::vector<Formula> recurring_parts(Formula f) {
  std::vector<Formula> out;
  const std::optional<Junction> parts = junction(f);
  const bool all = parts && parts->op == Op::And;
  for (Formula g : all ? parts->operands : std::vector<Formula>{f}) {
    if (!is_always(g) || !ltl::purity(g[1]).eventual) return {};
    const Formula e = is_eventually(g[1]) ? g[1][1] : g[1];
    if (!ltl::fragments(e, ltl::Semantics::Infinite).cosafety) return {};
    out.push_back(e);
  }
  return out;
}

Split::Split(Formula f, Late late) : late_(late) { over_ = tree(f); }

Condition Split::tree(Formula f) {
  const std::optional<Junction> parts = is_obligation(f) ? std::nullopt : junction(f);
  if (!parts) return literal(f);
  const bool all = parts->op == Op::And;
  const auto joined = [&](const std::vector<Formula>& operands) {
    return all ? ltl::conjunction(f.arena(), operands) : ltl::disjunction(f.arena(), operands);
  };
  const auto waits = [&](Formula g) {
    return late_ == Late::Together && !recurring_parts(all ? g : ltl::nnf(ltl::negate(g))).empty();
  };
  std::vector<Formula> obligations, late, rest;
  for (Formula g : parts->operands) (is_obligation(g) ? obligations : waits(g) ? late : rest).push_back(g);
  std::vector<Condition> operands;
  if (!obligations.empty()) operands.push_back(literal(joined(obligations)));
  if (!late.empty()) operands.push_back(literal(joined(late)));
  for (Formula g : rest) operands.push_back(tree(g));
  return all ? Condition::all_of(std::move(operands)) : Condition::any_of(std::move(operands));
}

Condition Split::literal(Formula f) {
  const Formula opposite = ltl::nnf(ltl::negate(f));
  for (std::uint32_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i] == f) return Condition::inf(i);
    if (parts_[i] == opposite) return Condition::fin(i);
  }
  if (parts_.size() == Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  parts_.push_back(f);
  return Condition::inf(static_cast<std::uint32_t>(parts_.size() - 1));
}

}  // namespace waymark::automata
