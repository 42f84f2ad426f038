#include "libltl/rewriting/separate.hpp"

#include <algorithm>
#include <vector>

#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/by_subformula.hpp"
#include "libltl/structure/walk.hpp"

namespace waymark::ltl {
namespace {

constexpr int most_passes = 4;

class Separation {
 public:
  explicit Separation(Arena& arena) : arena_(arena) {}

  Formula pass(Formula f) {
    std::vector<Formula> operands;
    const auto rewritten = [&](Formula g, const BySubformula<Formula>& image) {
      operands.clear();
      for (Formula operand : g.operands()) operands.push_back(image.at(operand));
      return rewrite(g, operands);
    };
    return BySubformula<Formula>(f, rewritten).top();
  }

 private:
  bool eventual(Formula f) { return purities_.of(f).eventual; }
  bool universal(Formula f) { return purities_.of(f).universal; }
  bool both(Formula f) { return purities_.of(f).both(); }

  Formula join(Op op, const std::vector<Formula>& parts) {
    return op == Op::And ? conjunction(arena_, parts) : disjunction(arena_, parts);
  }
  // The operands of a junction, the others are one operand of it.
  static std::vector<Formula> parts(Formula f, Op op) {
    if (f.op() != op) return {f};
    return {f.operands().begin(), f.operands().end()};
  }
  struct Split {
    std::vector<Formula> out, rest;
  };
  template <class Goes>
  static Split split(Formula f, Op op, const Goes& goes) {
    Split made;
    for (Formula g : parts(f, op)) (goes(g) ? made.out : made.rest).push_back(g);
    return made;
  }

  Formula rewrite(Formula f, const std::vector<Formula>& operands) {
    switch (f.op()) {
      case Op::False:
      case Op::True:
      case Op::Atom:
      case Op::Not:
      case Op::Yesterday:
      case Op::Since:
      case Op::Iff: return f;
      case Op::And: return junction(Op::And, conjunction(arena_, operands));
      case Op::Or: return junction(Op::Or, disjunction(arena_, operands));
      case Op::Next:
      case Op::WeakNext: return shift(operands[0]);
      case Op::Until: return temporal(Op::Until, operands[0], operands[1]);
      case Op::Release: return temporal(Op::Release, operands[0], operands[1]);
    }
    return f;  // unreachable: -Werror=switch
  }

  // match:  X q, X(φ ∧ q), X(φ ∨ q) with q both eventual and universal
  // result: q, X φ ∧ q, X φ ∨ q
  Formula shift(Formula f) {
    if (f.op() != Op::And && f.op() != Op::Or) return both(f) ? f : next(f);
    Split made = split(f, f.op(), [&](Formula g) { return both(g); });
    if (!made.rest.empty()) made.out.push_back(next(join(f.op(), made.rest)));
    return join(f.op(), made.out);
  }

  // match:  (φ U ψ) ∨ G φ, (φ R ψ) ∧ F φ
  // result: φ W ψ, φ M ψ
  Formula weakened(Op op, Formula f) {
    const bool any = op == Op::Or;
    std::vector<Formula> all(f.operands().begin(), f.operands().end());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < all.size(); ++j) {
        const Formula g = all[i], h = all[j];
        if (g.op() != (any ? Op::Until : Op::Release) || !(any ? is_always(h) : is_eventually(h)) || h[1] != g[0])
          continue;
        all[i] = any ? weak_until(g[0], g[1]) : strong_release(g[0], g[1]);
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(j));
        return join(op, all);
      }
    return f;
  }

  // match:  G φ ∨ F(¬φ ∧ e) with e eventual, F φ ∧ G(¬φ ∨ u) with u universal
  // result: φ W (¬φ ∧ e), ¬φ U (φ ∧ u)
  Formula junction(Op op, Formula f) {
    if (f.op() == op) f = weakened(op, f);
    if (f.op() != op) return f;
    const bool any = op == Op::Or;
    std::vector<Formula> all(f.operands().begin(), f.operands().end());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (!(any ? is_always(all[i]) && is_eventually(all[j]) : is_eventually(all[i]) && is_always(all[j]))) continue;
        const Formula kept = all[i][1], inner = all[j][1], other = nnf(negate(kept));
        const std::vector<Formula> inside = parts(inner, any ? Op::And : Op::Or);
        const auto fits = [&](Formula g) { return g == other || (any ? eventual(g) : universal(g)); };
        if (inside.size() < 2 || std::find(inside.begin(), inside.end(), other) == inside.end() ||
            !std::all_of(inside.begin(), inside.end(), fits))
          continue;
        const auto rest = split(inner, any ? Op::And : Op::Or, [&](Formula g) { return g == other; }).rest;
        all[i] = any ? weak_until(kept, inner) : until(other, conjunction(kept, join(Op::Or, rest)));
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(j));
        return join(op, all);
      }
    return f;
  }

  // U as it stands here, R with ∧ and ∨, eventual and universal exchanged.
  Formula temporal(Op op, Formula left, Formula right) {
    const bool is_until = op == Op::Until;
    const Op wide = is_until ? Op::Or : Op::And, narrow = is_until ? Op::And : Op::Or;
    const auto pure = [&](Formula g) { return is_until ? eventual(g) : universal(g); };
    const auto mixed = [&](Formula g) { return both(g); };
    const auto make = [&](Formula a, Formula b) { return is_until ? until(a, b) : release(a, b); };
    // match: φ U e   result: e
    if (pure(right)) return right;
    // match: φ U (ψ ∨ e)   result: (φ U ψ) ∨ e
    if (Split made = split(right, wide, pure); !made.out.empty()) {
      made.out.push_back(temporal(op, left, join(wide, made.rest)));
      return join(wide, made.out);
    }
    // match: φ U (φ ∧ e)   result: φ ∧ e
    if (right.op() == narrow) {
      const Split made = split(right, narrow, pure);
      if (!made.out.empty() && join(narrow, made.rest) == left) return right;
    }
    // match: φ U ((ψ ∧ q) ∨ χ)   result: ((φ U ψ) ∧ q) ∨ (φ U χ)
    if (Split made = split(right, wide,
                           [&](Formula g) {
                             const Split inner = split(g, narrow, mixed);
                             return !inner.out.empty() && !inner.rest.empty();
                           });
        !made.out.empty() && made.out.size() + made.rest.size() > 1) {
      for (Formula& g : made.out) g = temporal(op, left, g);
      if (!made.rest.empty()) made.out.push_back(temporal(op, left, join(wide, made.rest)));
      return join(wide, made.out);
    }
    // match: φ U (ψ ∧ q)   result: (φ U ψ) ∧ q
    if (Split made = split(right, narrow, mixed); !made.out.empty() && !made.rest.empty()) {
      made.out.push_back(temporal(op, left, join(narrow, made.rest)));
      return join(narrow, made.out);
    }
    // match: φ U (ψ ∨ G φ)   result: φ W ψ
    if (Split made =
            split(right, wide, [&](Formula g) { return (is_until ? is_always(g) : is_eventually(g)) && g[1] == left; });
        !made.out.empty()) {
      const Formula rest = join(wide, made.rest);
      return is_until ? weak_until(left, rest) : strong_release(left, rest);
    }
    const bool free = left.op() == (is_until ? Op::True : Op::False);
    if (free) {
      if (const Formula found = recurring(is_until, right); found != right) return found;
      return distributed(is_until, right);
    }
    // match: u U ψ, u U (u ∧ ψ)   result: (u ∨ ψ) ∧ F ψ, u ∧ F ψ
    if (is_until ? universal(left) : eventual(left)) {
      const Split made = split(right, narrow, [&](Formula g) { return g == left; });
      const Formula rest = join(narrow, made.rest), late = is_until ? eventually(rest) : always(rest);
      return join(narrow, {made.out.empty() ? join(wide, {left, right}) : left, late});
    }
    // match: (φ ∧ q) U ψ   result: ψ ∨ (q ∧ (φ U ψ))
    if (Split made = split(left, narrow, mixed); !made.out.empty()) {
      made.out.push_back(make(join(narrow, made.rest), right));
      return join(wide, {right, join(narrow, made.out)});
    }
    // match: (φ ∨ q) U ψ   result: (φ U ψ) ∨ (q ∧ F ψ)
    if (Split made = split(left, wide, mixed); !made.out.empty()) {
      const Formula late = is_until ? eventually(right) : always(right);
      return join(wide, {make(join(wide, made.rest), right), join(narrow, {join(wide, made.out), late})});
    }
    return make(left, right);
  }

  // match:  F G(φ ∨ u), F G(φ ∨ X u), F G X φ with u universal (and G F(φ ∧ e), …, dually)
  // result: F G φ ∨ F u,               F G φ
  // The operand itself when nothing matches.
  Formula recurring(bool is_until, Formula right) {
    if (!(is_until ? is_always(right) : is_eventually(right))) return right;
    const auto inner = [&](Formula g) { return is_until ? always(g) : eventually(g); };
    const auto outer = [&](Formula g) { return is_until ? eventually(g) : always(g); };
    const auto bare = [](Formula g) {
      while (g.op() == Op::Next) g = g[0];
      return g;
    };
    const Op wide = is_until ? Op::Or : Op::And;
    const Split made =
        split(right[1], wide, [&](Formula g) { return is_until ? universal(bare(g)) : eventual(bare(g)); });
    if (made.out.empty() && bare(right[1]) == right[1]) return right;
    std::vector<Formula> all;
    for (Formula g : made.out) all.push_back(outer(bare(g)));
    if (!made.rest.empty()) {
      const Formula rest = join(wide, made.rest);
      all.push_back(outer(inner(bare(rest))));
    }
    return join(wide, all);
  }

  // match:  G(φ ∧ e)
  // result: G φ ∧ G e      (F(φ ∨ u) stays: one F is one promise)
  Formula distributed(bool is_until, Formula right) {
    const Split made = split(right, Op::And, [&](Formula g) { return eventual(g); });
    if (is_until) return eventually(right);
    if (made.out.empty() || made.out.size() + made.rest.size() < 2) return always(right);
    std::vector<Formula> all;
    for (Formula g : made.out) all.push_back(temporal(Op::Release, arena_.constant(false), g));
    if (!made.rest.empty()) all.push_back(always(conjunction(arena_, made.rest)));
    return conjunction(arena_, all);
  }

  Arena& arena_;
  Purities purities_;
};

}  // namespace

Purity Purities::compute(Formula f) const {
  const auto all = [&] {
    Purity out{true, true};
    for (Formula g : f.operands())
      out = {out.eventual && known_.at(g).eventual, out.universal && known_.at(g).universal};
    return out;
  };
  switch (f.op()) {
    case Op::False:
    case Op::True: return {true, true};
    case Op::Atom:
    case Op::Not:
    case Op::Yesterday:
    case Op::Since:
    case Op::Iff: return {};
    case Op::And:
    case Op::Or:
    case Op::Next:
    case Op::WeakNext: return all();
    case Op::Until: return {f[0].op() == Op::True || known_.at(f[1]).eventual, known_.at(f[1]).universal};
    case Op::Release: return {known_.at(f[1]).eventual, f[0].op() == Op::False || known_.at(f[1]).universal};
  }
  return {};  // unreachable: -Werror=switch
}

Purity Purities::of(Formula f) {
  for (Formula g : unknown_subformulas(f, [&](Formula h) { return known_.contains(h); })) known_.emplace(g, compute(g));
  return known_.at(f);
}

Purity purity(Formula f) { return Purities().of(f); }

Formula separate(Formula f) {
  Separation separation(f.arena());
  for (int i = 0; i < most_passes; ++i) {
    const Formula before = f;
    f = separation.pass(f);
    if (f == before) break;
  }
  return f;
}

}  // namespace waymark::ltl
