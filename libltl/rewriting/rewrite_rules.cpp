// Sources of the rules: [BK08, Sec. 5.1.4] and Somenzi and Bloem, Efficient Büchi automata from LTL formulae
// (CAV 2000); those about the end of a finite word are ours.
#include "libltl/rewriting/rewrite_rules.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace waymark::ltl {
namespace {

using Result = std::optional<Formula>;

bool is(Formula f, Op op) { return f.op() == op; }
Formula constant(Formula like, bool value) { return like.arena().constant(value); }

// match:  N φ
// result: X φ
Result weak_next_is_next(Formula f, Implication&) {
  if (!is(f, Op::WeakNext)) return {};
  return next(f[0]);
}

// match:  X true, N false
// result: true, false
Result there_is_a_next(Formula f, Implication&) {
  if (is(f, Op::Next) && is(f[0], Op::True)) return f[0];
  if (is(f, Op::WeakNext) && is(f[0], Op::False)) return f[0];
  return {};
}

// match:  X false, N true
// result: false, true
Result next_of_constant(Formula f, Implication&) {
  if (is(f, Op::Next) && is(f[0], Op::False)) return f[0];
  if (is(f, Op::WeakNext) && is(f[0], Op::True)) return f[0];
  return {};
}

// match:  φ U ψ with φ ⇒ ψ (so φ U φ, false U φ, φ U true)
// result: ψ
Result until_by_right(Formula f, Implication& implies) {
  if (!is(f, Op::Until) || !implies(f[0], f[1])) return {};
  return f[1];
}

// match:  φ R ψ with ψ ⇒ φ (so φ R φ, true R φ, φ R false)
// result: ψ
Result release_by_right(Formula f, Implication& implies) {
  if (!is(f, Op::Release) || !implies(f[1], f[0])) return {};
  return f[1];
}

// match:  φ U false, φ R true
// result: false, true
Result constant_right(Formula f, Implication&) {
  if (is(f, Op::Until) && is(f[1], Op::False)) return f[1];
  if (is(f, Op::Release) && is(f[1], Op::True)) return f[1];
  return {};
}

// match:  (φ ∧ χ) U ψ with ¬ψ ⇒ φ, (φ ∨ χ) R ψ with φ ⇒ ¬ψ
// result: χ U ψ, χ R ψ         (all of them: F ψ, G ψ)
Result idle_on_the_left(Formula f, Implication& implies) {
  const bool is_until = is(f, Op::Until),
             ends = is_until ? is(f[0], Op::True) : is(f, Op::Release) && is(f[0], Op::False);
  if ((!is_until && !is(f, Op::Release)) || ends) return {};
  const Op junction = is_until ? Op::And : Op::Or;
  std::vector<Formula> all{f[0]}, kept;
  if (is(f[0], junction)) all.assign(f[0].operands().begin(), f[0].operands().end());
  const Formula opposite = implies.opposite(f[1]);
  for (Formula g : all)
    if (is_until ? !implies(opposite, g) : !implies(g, opposite)) kept.push_back(g);
  if (kept.size() == all.size()) return {};
  return is_until ? until(conjunction(f.arena(), kept), f[1]) : release(disjunction(f.arena(), kept), f[1]);
}

// match:  φ U (ψ U χ) with φ ⇒ ψ, φ R (ψ R χ) with ψ ⇒ φ
// result: ψ U χ, ψ R χ
Result absorbed_on_the_left(Formula f, Implication& implies) {
  if (is(f, Op::Until) && is(f[1], Op::Until) && implies(f[0], f[1][0])) return f[1];
  if (is(f, Op::Release) && is(f[1], Op::Release) && implies(f[1][0], f[0])) return f[1];
  return {};
}

// match:  (φ U ψ) U ψ, (φ R ψ) R ψ
// result: φ U ψ, φ R ψ
Result repeated_on_the_left(Formula f, Implication&) {
  if (!is(f, Op::Until) && !is(f, Op::Release)) return {};
  if (f[0].op() != f.op() || f[0][1] != f[1]) return {};
  return f[0];
}

// match:  F(φ U ψ), G(φ R ψ)
// result: F ψ, G ψ
Result guard_under_eventually(Formula f, Implication&) {
  if (is_eventually(f) && is(f[1], Op::Until)) return eventually(f[1][1]);
  if (is_always(f) && is(f[1], Op::Release)) return always(f[1][1]);
  return {};
}

// match:  F(φ ∨ (ψ U χ)), G(φ ∧ (ψ R χ))
// result: F(φ ∨ χ), G(φ ∧ χ)
Result guard_in_junction(Formula f, Implication&) {
  const bool exists = is_eventually(f) && is(f[1], Op::Or), all = is_always(f) && is(f[1], Op::And);
  if (!exists && !all) return {};
  bool changed = false;
  std::vector<Formula> parts;
  for (Formula g : f[1].operands()) {
    const bool guarded = is(g, exists ? Op::Until : Op::Release);
    changed = changed || guarded;
    parts.push_back(guarded ? g[1] : g);
  }
  if (!changed) return {};
  return exists ? eventually(disjunction(f.arena(), parts)) : always(conjunction(f.arena(), parts));
}

// match:  F G F φ, G F G φ
// result: G F φ, F G φ
Result recurring(Formula f, Implication&) {
  if (is_eventually(f) && is_always(f[1]) && is_eventually(f[1][1])) return f[1];
  if (is_always(f) && is_eventually(f[1]) && is_always(f[1][1])) return f[1];
  return {};
}

// match:  G F φ
// result: F G φ        (both: φ at the last position)
Result at_the_end(Formula f, Implication&) {
  if (!is_always(f) || !is_eventually(f[1])) return {};
  return eventually(always(f[1][1]));
}

// match:  X φ U X ψ, N φ R N ψ, F X φ, G N φ
// result: X(φ U ψ), N(φ R ψ), X F φ, N G φ
Result next_outwards(Formula f, Implication&) {
  if (is(f, Op::Until) && is(f[1], Op::Next)) {
    if (is(f[0], Op::True)) return next(eventually(f[1][0]));
    if (is(f[0], Op::Next)) return next(until(f[0][0], f[1][0]));
  }
  if (is(f, Op::Release) && is(f[1], Op::WeakNext)) {
    if (is(f[0], Op::False)) return weak_next(always(f[1][0]));
    if (is(f[0], Op::WeakNext)) return weak_next(release(f[0][0], f[1][0]));
  }
  return {};
}

// match:  X φ R X ψ, G X φ
// result: X(φ R ψ), X G φ
Result next_out_of_release(Formula f, Implication&) {
  if (!is(f, Op::Release) || !is(f[1], Op::Next)) return {};
  if (is(f[0], Op::False)) return next(always(f[1][0]));
  if (is(f[0], Op::Next)) return next(release(f[0][0], f[1][0]));
  return {};
}

// Operands of longer junctions are not compared two by two.
bool is_short_junction(Formula f) {
  constexpr std::size_t most_operands = 4'096;
  return (is(f, Op::And) || is(f, Op::Or)) && f.operands().size() <= most_operands;
}

// match:  φ ∧ ψ with φ ⇒ ψ, φ ∨ ψ with ψ ⇒ φ
// result: φ
Result absorbed(Formula f, Implication& implies) {
  if (!is_short_junction(f)) return {};
  std::vector<Formula> kept(f.operands().begin(), f.operands().end());
  for (std::size_t i = 0; i < kept.size();) {
    const auto makes_idle = [&](Formula g) {
      return g != kept[i] && (is(f, Op::And) ? implies(g, kept[i]) : implies(kept[i], g));
    };
    // One at a time, so that of two formulas that imply each other one stays.
    if (std::any_of(kept.begin(), kept.end(), makes_idle))
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  if (kept.size() == f.operands().size()) return {};
  return is(f, Op::And) ? conjunction(f.arena(), kept) : disjunction(f.arena(), kept);
}

// match:  φ ∧ ψ with φ ⇒ ¬ψ, φ ∨ ψ with ¬φ ⇒ ψ
// result: false, true
Result contradiction(Formula f, Implication& implies) {
  if (!is_short_junction(f)) return {};
  std::vector<Formula> opposites;
  for (Formula g : f.operands()) opposites.push_back(implies.opposite(g));
  for (std::size_t i = 0; i < opposites.size(); ++i)
    for (std::size_t j = 0; j < opposites.size(); ++j)
      if (i != j && (is(f, Op::And) ? implies(f[i], opposites[j]) : implies(opposites[i], f[j])))
        return constant(f, is(f, Op::Or));
  return {};
}

// match:  φ ∨ ((φ′ ∨ ψ) ∧ χ) with φ′ ⇒ φ, φ ∧ ((φ′ ∧ ψ) ∨ χ) with φ ⇒ φ′
// result: φ ∨ (ψ ∧ χ), φ ∧ (ψ ∨ χ)
Result settled_beside(Formula f, Implication& implies) {
  if (!is_short_junction(f)) return {};
  const Op inner = is(f, Op::And) ? Op::Or : Op::And;
  const auto junction = [&](Op op, const std::vector<Formula>& parts) {
    return op == Op::And ? conjunction(f.arena(), parts) : disjunction(f.arena(), parts);
  };
  const auto without = [&](std::span<const Formula> all, std::size_t at, Formula instead) {
    std::vector<Formula> parts(all.begin(), all.end());
    parts[at] = instead;
    return parts;
  };
  for (std::size_t i = 0; i < f.operands().size(); ++i)
    for (std::size_t j = 0; is(f[i], inner) && j < f[i].operands().size(); ++j) {
      if (f[i][j].op() != f.op()) continue;
      std::vector<Formula> rest;
      for (Formula x : f[i][j].operands())
        if (std::none_of(f.operands().begin(), f.operands().end(),
                         [&](Formula g) { return g != f[i] && (is(f, Op::Or) ? implies(x, g) : implies(g, x)); }))
          rest.push_back(x);
      if (rest.size() == f[i][j].operands().size()) continue;
      const Formula smaller = junction(inner, without(f[i].operands(), j, junction(f.op(), rest)));
      return junction(f.op(), without(f.operands(), i, smaller));
    }
  return {};
}

// Joins the first two operands of a junction that `join` can join.
template <class Join>
Result join_two(Formula f, Op op, Join join) {
  if (!is(f, op) || !is_short_junction(f)) return {};
  const auto parts = f.operands();
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      const Result joined = join(parts[i], parts[j]);
      if (!joined) continue;
      std::vector<Formula> rest{*joined};
      for (std::size_t k = 0; k < parts.size(); ++k)
        if (k != i && k != j) rest.push_back(parts[k]);
      return op == Op::And ? conjunction(f.arena(), rest) : disjunction(f.arena(), rest);
    }
  return {};
}

// match:  (φ ∨ ψ) ∧ (φ ∨ χ), (φ ∧ ψ) ∨ (φ ∧ χ)
// result: φ ∨ (ψ ∧ χ), φ ∧ (ψ ∨ χ)
Result factored(Formula f, Implication&) {
  if (!is(f, Op::And) && !is(f, Op::Or)) return {};
  const Op outer = f.op(), inner = outer == Op::And ? Op::Or : Op::And;
  const auto junction = [&](Op op, const std::vector<Formula>& all) {
    return op == Op::And ? conjunction(f.arena(), all) : disjunction(f.arena(), all);
  };
  return join_two(f, outer, [&](Formula g, Formula h) -> Result {
    if (g.op() != inner || h.op() != inner) return {};
    const auto left = g.operands(), right = h.operands();
    std::vector<Formula> common, g_only, h_only;
    std::set_intersection(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(common));
    if (common.empty()) return {};
    std::set_difference(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(g_only));
    std::set_difference(right.begin(), right.end(), left.begin(), left.end(), std::back_inserter(h_only));
    const Formula rests[] = {junction(inner, g_only), junction(inner, h_only)};
    common.push_back(junction(outer, {rests[0], rests[1]}));
    return junction(inner, common);
  });
}

bool is_next(Formula f) { return is(f, Op::Next) || is(f, Op::WeakNext); }

// match:  X φ ∧ X ψ, N φ ∧ N ψ, X φ ∧ N ψ, and the same with ∨
// result: X(φ ∧ ψ), N(φ ∧ ψ), X(φ ∧ ψ), and X(φ ∨ ψ), N(φ ∨ ψ), N(φ ∨ ψ)
Result nexts_joined(Formula f, Implication&) {
  if (auto joined = join_two(f, Op::And, [](Formula g, Formula h) -> Result {
        if (!is_next(g) || !is_next(h)) return {};
        const Formula both = conjunction(g[0], h[0]);
        return is(g, Op::Next) || is(h, Op::Next) ? next(both) : weak_next(both);
      }))
    return joined;
  return join_two(f, Op::Or, [](Formula g, Formula h) -> Result {
    if (!is_next(g) || !is_next(h)) return {};
    const Formula either = disjunction(g[0], h[0]);
    return is(g, Op::Next) && is(h, Op::Next) ? next(either) : weak_next(either);
  });
}

// match:  (φ U ψ) ∧ (χ U ψ), (φ R ψ) ∧ (φ R χ)
// result: (φ ∧ χ) U ψ, φ R (ψ ∧ χ)
Result joined_by_and(Formula f, Implication&) {
  return join_two(f, Op::And, [](Formula g, Formula h) -> Result {
    if (is(g, Op::Until) && is(h, Op::Until) && g[1] == h[1]) return until(conjunction(g[0], h[0]), g[1]);
    if (is(g, Op::Release) && is(h, Op::Release) && g[0] == h[0]) return release(g[0], conjunction(g[1], h[1]));
    return {};
  });
}

// match:  (φ U ψ) ∨ (φ U χ), (φ R ψ) ∨ (χ R ψ)
// result: φ U (ψ ∨ χ), (φ ∨ χ) R ψ
Result joined_by_or(Formula f, Implication&) {
  return join_two(f, Op::Or, [](Formula g, Formula h) -> Result {
    if (is(g, Op::Until) && is(h, Op::Until) && g[0] == h[0]) return until(g[0], disjunction(g[1], h[1]));
    if (is(g, Op::Release) && is(h, Op::Release) && g[1] == h[1]) return release(disjunction(g[0], h[0]), g[1]);
    return {};
  });
}

// match:  F G φ ∧ F G ψ, G F φ ∨ G F ψ
// result: F G(φ ∧ ψ), G F(φ ∨ ψ)
Result recurring_joined(Formula f, Implication&) {
  const auto persists = [](Formula g) { return is_eventually(g) && is_always(g[1]); };
  const auto recurs = [](Formula g) { return is_always(g) && is_eventually(g[1]); };
  if (auto joined = join_two(f, Op::And, [&](Formula g, Formula h) -> Result {
        if (!persists(g) || !persists(h)) return {};
        return eventually(always(conjunction(g[1][1], h[1][1])));
      }))
    return joined;
  return join_two(f, Op::Or, [&](Formula g, Formula h) -> Result {
    if (!recurs(g) || !recurs(h)) return {};
    return always(eventually(disjunction(g[1][1], h[1][1])));
  });
}

constexpr RewriteRule rules[] = {
    {"weak next is next", weak_next_is_next, false, true},
    {"there is a next", there_is_a_next, false, true},
    {"next of a constant", next_of_constant, true, true},
    {"constant on the right", constant_right, true, true},
    {"until by its right side", until_by_right, true, true},
    {"release by its right side", release_by_right, true, true},
    {"idle on the left", idle_on_the_left, true, true},
    {"absorbed on the left", absorbed_on_the_left, true, true},
    {"repeated on the left", repeated_on_the_left, true, true},
    {"guard under eventually", guard_under_eventually, true, true},
    {"guard in a junction", guard_in_junction, true, true},
    {"recurring", recurring, true, true},
    {"at the end", at_the_end, true, false},
    {"next outwards", next_outwards, true, true},
    {"next out of release", next_out_of_release, false, true},
    {"absorbed", absorbed, true, true},
    {"contradiction", contradiction, true, true},
    {"settled beside", settled_beside, true, true},
    {"factored", factored, true, true},
    {"nexts joined", nexts_joined, true, true},
    {"joined by and", joined_by_and, true, true},
    {"joined by or", joined_by_or, true, true},
    {"recurring joined", recurring_joined, true, true},
};

}  // namespace

std::span<const RewriteRule> rewrite_rules() { return rules; }

}  // namespace waymark::ltl
