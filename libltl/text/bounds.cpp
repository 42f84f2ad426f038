#include "libltl/text/bounds.hpp"

#include <algorithm>
#include <iterator>

namespace waymark::ltl {

namespace {

// all \ some, both sorted; nothing when some ⊄ all.
std::optional<std::vector<Formula>> rest_of(std::span<const Formula> all, std::span<const Formula> some) {
  if (!std::includes(all.begin(), all.end(), some.begin(), some.end())) return std::nullopt;
  std::vector<Formula> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

std::optional<Bounds::Part> Bounds::part(std::span<const Formula> operands, Op junction) {
  std::optional<Part> best;
  const auto try_out = [&](Formula next, const Bound& bound) {
    std::vector<Formula> members{bound.body};
    if (bound.body.op() == junction) members.assign(bound.body.operands().begin(), bound.body.operands().end());
    members.insert(std::lower_bound(members.begin(), members.end(), next), next);
    std::optional<std::vector<Formula>> rest = rest_of(operands, members);
    if (!rest || (best && best->rest.empty())) return;
    if (!best || rest->empty() || bound.steps > best->bound.steps) best = {bound, std::move(members), *std::move(rest)};
  };
  for (const Formula& next : operands) {
    if (next.op() != Op::Next && next.op() != Op::WeakNext) continue;
    const std::optional<Bound> inner = of(next[0]);
    if (inner && inner->junction == junction && inner->next == next.op())
      try_out(next, {inner->body, inner->steps + 1, junction, next.op()});
    try_out(next, {next[0], 1, junction, next.op()});
  }
  return best;
}

std::optional<Bound> Bounds::of(Formula f) {
  if (f.op() != Op::And && f.op() != Op::Or) return std::nullopt;
  if (const auto known = known_.find(f.id()); known != known_.end()) return known->second;
  const std::optional<Part> found = part(f.operands(), f.op());
  const std::optional<Bound> bound = found && found->rest.empty() ? std::optional(found->bound) : std::nullopt;
  return known_.emplace(f.id(), bound).first->second;
}

bool Bounds::implies(Formula from, Formula to) {
  if (from.op() != to.op()) return false;
  const std::optional<Bound> a = of(from), b = of(to);
  if (!a || !b || !a->is_of(*b)) return false;
  return a->junction == Op::Or ? a->steps <= b->steps : a->steps >= b->steps;
}

bool has_bounds(Formula f) {
  Bounds bounds;
  const std::vector<Formula> all = subformulas(f);
  return std::any_of(all.begin(), all.end(), [&](Formula g) {
    const std::optional<Bound> bound = bounds.of(g);
    return bound && bound->steps > 1;
  });
}

}  // namespace waymark::ltl
