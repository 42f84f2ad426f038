// The classes are computed from the operands up. Obligation, recurrence and persistence follow the grammar that goes
// with [CMP92]: an until whose right side is co-safe stays an obligation or a recurrence, and so on, dually.
#include "libltl/structure/fragment.hpp"

#include <unordered_map>

#include "libltl/text/symbol.hpp"
#include "libltl/text/view.hpp"

namespace waymark::ltl {
namespace {

constexpr Fragments everything{true, true, true, true, true, true, true};

Fragments both(const Fragments& a, const Fragments& b) {
  return {a.propositional && b.propositional, a.next_free && b.next_free,   a.safety && b.safety,
          a.cosafety && b.cosafety,           a.obligation && b.obligation, a.recurrence && b.recurrence,
          a.persistence && b.persistence};
}

Fragments negated(const Fragments& a) {
  return {a.propositional, a.next_free, a.cosafety, a.safety, a.obligation, a.persistence, a.recurrence};
}

// What is in a class is in the classes above it.
Fragments upwards(Fragments a) {
  a.obligation = a.obligation || a.safety || a.cosafety;
  a.recurrence = a.recurrence || a.obligation;
  a.persistence = a.persistence || a.obligation;
  return a;
}

Fragments of_until(const Fragments& a, const Fragments& b) {
  return upwards({.propositional = false,
                  .next_free = a.next_free && b.next_free,
                  .safety = false,
                  .cosafety = a.cosafety && b.cosafety,
                  .obligation = a.obligation && b.cosafety,
                  .recurrence = a.recurrence && b.cosafety,
                  .persistence = a.persistence && b.persistence});
}

// φ W ψ is stored as ψ R (φ ∨ ψ), which hides that φ alone has to be safe for the whole to be an obligation.
Fragments of_weak_until(const Fragments& a, const Fragments& b, Fragments known) {
  known.obligation = known.obligation || (a.safety && b.obligation);
  known.persistence = known.persistence || (a.safety && b.persistence);
  return upwards(known);
}

class Classifier {
 public:
  explicit Classifier(Semantics semantics) : finite_(semantics == Semantics::Finite) {}

  Fragments classify(Formula f) {
    for (Formula g : subformulas(f)) known_.emplace(g, one(g));
    return known_.at(f);
  }

 private:
  const Fragments& at(Formula f) const { return known_.at(f); }

  Fragments all(const std::vector<Formula>& parts) const {
    Fragments out = everything;
    for (Formula g : parts) out = both(out, at(g));
    return out;
  }

  Fragments of_next(Formula f) const {
    Fragments out = at(f[0]);
    out.propositional = out.next_free = false;
    if (finite_) (f.op() == Op::Next ? out.safety : out.cosafety) = false;
    return out;
  }

  // At every position a finite positive combination of the operands at earlier positions, so every class is kept.
  Fragments of_past(Formula f) const {
    Fragments out = all({f.operands().begin(), f.operands().end()});
    out.propositional = false;
    out.next_free = out.next_free && f.op() == Op::Since;
    return out;
  }

  // φ R ψ is ¬(¬φ U ¬ψ). The weak until (and, negated, the strong release) is looked at as it was written.
  Fragments of_binary(Formula f) const {
    const bool until = f.op() == Op::Until;
    const auto plain = [&](const Fragments& a, const Fragments& b) {
      return until ? of_until(a, b) : negated(of_until(negated(a), negated(b)));
    };
    const Fragments known = plain(at(f[0]), at(f[1]));
    const View seen = view(f);
    if (seen.symbol != Symbol::WeakUntil && seen.symbol != Symbol::StrongRelease) return known;
    const Fragments a = all(seen.operands[0].parts), b = all(seen.operands[1].parts);
    if (!until) return of_weak_until(a, b, known);
    return negated(of_weak_until(negated(a), negated(b), negated(known)));
  }

  Fragments one(Formula f) const {
    switch (f.op()) {
      case Op::False:
      case Op::True:
      case Op::Atom: return everything;
      case Op::Not: return negated(at(f[0]));
      case Op::And:
      case Op::Or: return all({f.operands().begin(), f.operands().end()});
      case Op::Iff: {
        const Fragments a = both(at(f[0]), at(f[1]));
        return both(a, negated(a));
      }
      case Op::Next:
      case Op::WeakNext: return of_next(f);
      case Op::Until:
      case Op::Release: return of_binary(f);
      case Op::Yesterday:
      case Op::Since: return of_past(f);
    }
    return {};  // unreachable: -Werror=switch
  }

  bool finite_;
  std::unordered_map<Formula, Fragments> known_;
};

}  // namespace

Fragments fragments(Formula f, Semantics semantics) {
  Fragments out = Classifier(semantics).classify(f);
  if (semantics == Semantics::Finite) out.obligation = out.recurrence = out.persistence = false;
  return out;
}

}  // namespace waymark::ltl
