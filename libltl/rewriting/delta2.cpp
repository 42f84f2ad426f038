// The rules, in the notation of the paper: φ[ψ] is a formula in which ψ occurs, φ[χ] the same with χ in its place. All
// formulas are in negation normal form, hence monotone in ψ. They rest on two facts: where G F ψ₂ holds, ψ₁ U ψ₂ and
// ψ₁ W ψ₂ are the same everywhere; where it does not, ψ₁ U ψ₂ is false from some position on.
#include "libltl/rewriting/delta2.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/by_subformula.hpp"
#include "libltl/structure/hierarchy.hpp"
#include "libltl/structure/walk.hpp"

namespace waymark::ltl {
namespace {

bool is_true(Formula f) { return f.op() == Op::True; }
bool is_false(Formula f) { return f.op() == Op::False; }
bool is_constant(Formula f) { return is_true(f) || is_false(f); }
// G F φ, F G φ: true at every position of a word or at none.
bool is_limit(Formula f) { return (is_always(f) && is_eventually(f[1])) || (is_eventually(f) && is_always(f[1])); }

// The constructors, with constants folded as is right for infinite words.
Formula nexted(Formula f) { return is_constant(f) ? f : next(f); }
Formula awaited(Formula a, Formula b) { return is_constant(b) || is_false(a) || a == b ? b : until(a, b); }
Formula released(Formula a, Formula b) { return is_constant(b) || is_true(a) || a == b ? b : release(a, b); }
Formula waited(Formula a, Formula b) { return released(b, disjunction(a, b)); }  // a W b

// Made anew from the operands up, but for those subformulas that have an image.
template <class Image>
Formula rebuilt(Formula f, const Image& image) {
  const auto make = [&](Formula g, const BySubformula<Formula>& known) {
    if (const std::optional<Formula> given = image(g)) return *given;
    std::vector<Formula> args;
    for (Formula operand : g.operands()) args.push_back(known.at(operand));
    switch (g.op()) {
      case Op::And: return conjunction(g.arena(), args);
      case Op::Or: return disjunction(g.arena(), args);
      case Op::Next:
      case Op::WeakNext: return nexted(args[0]);
      case Op::Until: return awaited(args[0], args[1]);
      case Op::Release: return released(args[0], args[1]);
      case Op::False:
      case Op::True:
      case Op::Atom:
      case Op::Not:
      case Op::Yesterday:
      case Op::Since:
      case Op::Iff: break;  // no equivalence is left, and ¬ stands before atoms and past operators
    }
    return g;
  };
  return BySubformula<Formula>(f, make).top();
}

std::vector<Formula> outside_limits(Formula f) {
  return walk(f, [](Formula g) { return !is_limit(g); });
}
// The operator, but for that of G F and F G.
struct Plain {
  Op op;
  bool operator()(Formula g) const { return g.op() == op && !is_limit(g); }
};

// Of a Boolean combination, each temporal formula replaced.
template <class Image>
Formula mapped(Formula f, const Image& image) {
  const auto boolean = [](Formula g) { return g.op() == Op::And || g.op() == Op::Or; };
  std::vector<Formula> layer = walk(f, boolean);
  std::unordered_map<Formula, Formula> known;
  for (auto g = layer.rbegin(); g != layer.rend(); ++g) {
    const bool temporal = g->op() == Op::Next || g->op() == Op::Until || g->op() == Op::Release;
    std::vector<Formula> images;
    if (boolean(*g))
      for (Formula operand : g->operands()) images.push_back(known.at(operand));
    known.emplace(*g, temporal             ? image(*g)
                      : g->op() == Op::And ? conjunction(f.arena(), images)
                      : g->op() == Op::Or  ? disjunction(f.arena(), images)
                                           : *g);
  }
  return known.at(f);
}

// f[from] → f[to], not inside of G F and F G.
Formula replaced(Formula f, Formula from, Formula to) {
  return rebuilt(f, [&](Formula g) {
    return g == from ? std::optional(to) : is_limit(g) ? std::optional(g) : std::nullopt;
  });
}
// In negation normal form, with one next.
Formula normal(Formula f) {
  return rebuilt(nnf(f), [](Formula) { return std::optional<Formula>(); });
}

// A release as it is easier to rewrite: kept W goal, or goal R kept when `meets`, which is kept W (goal ∧ kept).
struct Waiting {
  Formula kept, goal;
  bool meets;
  Formula end() const { return meets ? conjunction(goal, kept) : goal; }
  Formula weak() const { return meets ? released(goal, kept) : waited(kept, goal); }
  Formula strong() const { return awaited(kept, end()); }
  friend bool operator<(const Waiting& a, const Waiting& b) {
    return std::tuple(a.kept, a.goal, a.meets) < std::tuple(b.kept, b.goal, b.meets);
  }
};

std::vector<Formula> disjuncts(Formula f) {
  if (f.op() != Op::Or) return {f};
  return {f.operands().begin(), f.operands().end()};
}

// ψ R (φ ∨ ψ) is φ W ψ.
Waiting waiting(Formula f) {
  if (is_false(f[0])) return {f[1], f[0], false};
  const std::vector<Formula> all = disjuncts(f[1]), goal = disjuncts(f[0]);
  std::vector<Formula> kept;
  std::set_difference(all.begin(), all.end(), goal.begin(), goal.end(), std::back_inserter(kept));
  if (kept.size() + goal.size() != all.size()) return {f[1], f[0], true};
  return {disjunction(f.arena(), kept), f[0], false};
}

class Normalization {
 public:
  Normalization(Arena& arena, std::size_t most) : arena_(arena), most_(most) {}

  // Each temporal formula of the Boolean top by itself, as it is and negated.
  std::optional<Formula> run(Formula f) {
    bool all = true;
    const Formula out = mapped(normal(f), [&](Formula g) {
      if (is_delta2(g)) return g;
      const std::optional<Formula> straight = attempt(g);
      const std::optional<Formula> turned = attempt(normal(negate(g)));
      all = all && (straight || turned);
      if (!turned) return straight.value_or(g);
      const Formula back = normal(negate(*turned));
      return straight && subformulas(*straight).size() <= subformulas(back).size() ? *straight : back;
    });
    return all ? std::optional(out) : std::nullopt;
  }

 private:
  // Inside of no other one that is wanted, nor of G F and F G.
  template <class Wanted>
  std::optional<Formula> outermost(Formula f, const Wanted& wanted) {
    spend(f);
    const std::vector<Formula> all = outside_limits(f);
    const auto found = std::find_if(all.begin(), all.end(), wanted);
    return found == all.end() ? std::nullopt : std::optional(*found);
  }
  std::optional<Formula> outermost(Formula f, Op op) { return outermost(f, Plain{op}); }
  Formula constant(bool value) { return arena_.constant(value); }

  // Stage 1. Nothing inside of G F and F G counts.
  Formula without_until_under_wait(Formula f) {
    return mapped(f, [&](Formula g) {
      if (is_limit(g)) return g;
      const auto at = staged_.find(g);
      if (at != staged_.end()) return at->second;
      const Formula made = staged(g);
      staged_.emplace(g, made);
      return made;
    });
  }
  Formula staged(Formula f) {
    const Formula a = without_until_under_wait(f[0]);
    if (f.op() == Op::Next) return nexted(a);
    const Formula b = without_until_under_wait(f[1]);
    if (f.op() == Op::Until) return awaited(a, b);
    const Formula made = released(a, b);
    return made.op() == Op::Release && !is_limit(made) ? wait(waiting(made)) : made;
  }
  Formula wait(const Waiting& w) {
    const auto at = waited_.find(w);
    if (at != waited_.end()) return at->second;
    const Formula made = waits(w);
    waited_.emplace(w, made);
    return made;
  }
  // The first U to go has none left inside of the W in its place, so that φ stays without U under W: F ψ is such.
  // match:  φ W χ[U]       result: φ U χ[U] ∨ G φ
  // match:  φ[ψ₁ U ψ₂] W χ  result: (G F ψ₂ ∧ φ[ψ₁ W ψ₂] W χ) ∨ φ[ψ₁ U ψ₂] U (χ ∨ G φ[false])
  Formula waits(const Waiting& w) {
    const auto clean = [&](Formula g) { return Plain{Op::Until}(g) && !outermost(waited(g[0], g[1]), Op::Until); };
    if (const std::optional<Formula> u = outermost(w.kept, clean)) {
      const Formula promise = always(eventually((*u)[1]));
      const Formula often = wait({replaced(w.kept, *u, waited((*u)[0], (*u)[1])), w.goal, w.meets});
      const Formula late = wait({replaced(w.kept, *u, constant(false)), constant(false), false});
      const Formula soon = awaited(w.kept, disjunction(w.end(), late));
      return disjunction(conjunction(promise, often), soon);
    }
    if (!outermost(w.goal, Op::Until)) return w.weak();
    const Formula strong = w.strong();
    return disjunction(strong, released(constant(false), w.kept));
  }

  // Stage 2. λ = G F ψ or F G ψ:
  // match:  φ[λ]   result: (λ ∧ φ[true]) ∨ φ[false]
  Formula pulled(Formula f) {
    return mapped(f, [&](Formula g) {
      if (is_limit(g)) return limit(g);
      const std::optional<Formula> inner = outermost(g, is_limit);
      return !inner ? g : apart(g, *inner, &Normalization::pulled);
    });
  }

  // Stage 3.
  Formula limit(Formula f) {
    const auto at = limits_.find(f);
    if (at != limits_.end()) return at->second;
    const Formula made = is_always(f) ? often(f[1][1]) : for_ever(f[1][1]);
    limits_.emplace(f, made);
    return made;
  }
  // match:  G F φ[λ]        result: (λ ∧ G F φ[true]) ∨ G F φ[false]
  // match:  G F φ[ψ₁ W ψ₂]   result: G F φ[ψ₁ U ψ₂] ∨ (F G ψ₁ ∧ G F φ[true])
  Formula often(Formula f) {
    if (is_constant(f)) return f;
    if (f.op() == Op::Next) return often(f[0]);
    if (f.op() == Op::Until) return often(f[1]);
    if (f.op() == Op::Or) return each(f, &Normalization::often);
    if (const std::optional<Formula> inner = outermost(f, is_limit)) return apart(f, *inner, &Normalization::often);
    const std::optional<Formula> w = outermost(f, Op::Release);
    if (!w) return always(eventually(f));
    const Waiting seen = waiting(*w);
    const Formula strong = often(replaced(f, *w, seen.strong()));
    const Formula kept = for_ever(seen.kept);
    return disjunction(strong, conjunction(kept, often(replaced(f, *w, constant(true)))));
  }
  // match:  F G φ[ψ₁ U ψ₂]   result: (G F ψ₂ ∧ F G φ[ψ₁ W ψ₂]) ∨ F G φ[false]
  Formula for_ever(Formula f) {
    if (is_constant(f)) return f;
    if (f.op() == Op::Next) return for_ever(f[0]);
    if (f.op() == Op::Release) return for_ever(f[1]);
    if (f.op() == Op::And) return each(f, &Normalization::for_ever);
    if (const std::optional<Formula> inner = outermost(f, is_limit)) return apart(f, *inner, &Normalization::for_ever);
    const std::optional<Formula> u = outermost(f, Op::Until);
    if (!u) return eventually(always(f));
    const Formula promise = often((*u)[1]);
    const Formula weak = for_ever(replaced(f, *u, waited((*u)[0], (*u)[1])));
    const Formula late = for_ever(replaced(f, *u, constant(false)));
    return disjunction(conjunction(promise, weak), late);
  }
  using Late = Formula (Normalization::*)(Formula);
  Formula each(Formula f, Late late) {
    std::vector<Formula> all;
    for (Formula g : f.operands()) all.push_back((this->*late)(g));
    return f.op() == Op::And ? conjunction(arena_, all) : disjunction(arena_, all);
  }
  Formula apart(Formula f, Formula inner, Late late) {
    const Formula far = limit(inner);
    const Formula yes = (this->*late)(replaced(f, inner, constant(true)));
    const Formula no = (this->*late)(replaced(f, inner, constant(false)));
    return disjunction(conjunction(far, yes), no);
  }

  struct TooLarge {};
  std::optional<Formula> attempt(Formula f) {
    spent_ = 0;
    try {
      return pulled(without_until_under_wait(f));
    } catch (const TooLarge&) {
      return std::nullopt;
    }
  }
  void spend(Formula f) {
    if (++spent_ > most_ || subformulas(f).size() > most_) throw TooLarge{};
  }

  Arena& arena_;
  std::size_t most_, spent_ = 0;
  std::unordered_map<Formula, Formula> staged_, limits_;
  std::map<Waiting, Formula> waited_;
};

}  // namespace

std::optional<Formula> delta2(Formula f, std::size_t most) { return Normalization(f.arena(), most).run(f); }

}  // namespace waymark::ltl
